F100 G5.2 L3
X1 Y1
G1 X5
M30
; expect error 3:1 E4312
