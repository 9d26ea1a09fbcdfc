G18 G5.1 X1 I1 F100
M30
; expect error 1:5 E4311
