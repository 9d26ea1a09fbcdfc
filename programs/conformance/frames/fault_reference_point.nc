G30 P5 Z0
; expect error 1:5 E4008
M30
