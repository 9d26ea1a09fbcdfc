F100 G5.2
X1 Y1 L4
M30
; expect error 2:7 E4312
