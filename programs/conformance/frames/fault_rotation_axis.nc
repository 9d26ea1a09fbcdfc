G68 X1 Z1 R30
; expect error 1:8 E4302
M30
