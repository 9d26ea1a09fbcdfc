; A cycle that lacks something.
G93
G81 X1 Z-1 R1 F2
; expect error 3:1 E4065
M30
