G5.1 X1 Y1 I0 F100
M30
; expect error 1:1 E4007
