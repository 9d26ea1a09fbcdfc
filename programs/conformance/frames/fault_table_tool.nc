G10 L1 P44 Z1
; expect error 1:8 E5002
M30
