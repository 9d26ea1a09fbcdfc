F100 G5.2
X1 Y1
X2 Y2
X3
M30
; expect error 5:1 E4312
