; A cycle that lacks something.
F100
G81 X1 Z-1
; expect error 3:1 E4061
M30
