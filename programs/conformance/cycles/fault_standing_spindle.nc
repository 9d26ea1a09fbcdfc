; A cycle that lacks something.
F100
G86 X1 Z-1 R1 P1
; expect error 3:1 E4064
M30
