F100 G6.2 P3 K0 X0 Y1
M30
; expect error 1:6 E4312
