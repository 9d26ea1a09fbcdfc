; A cycle that lacks something.
F100
G81 X1 Z2 R1
; expect error 3:11 E4062
M30
