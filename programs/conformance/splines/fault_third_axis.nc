G5.1 X1 Z1 I1 F100
M30
; expect error 1:9 E4302
