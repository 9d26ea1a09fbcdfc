G5 X1 Y1 P1 Q1 F100
M30
; expect error 1:1 E4007
