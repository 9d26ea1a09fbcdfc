; A cycle that lacks something.
F100
G82 X1 Z-1 R1
; expect error 3:1 E4007
M30
