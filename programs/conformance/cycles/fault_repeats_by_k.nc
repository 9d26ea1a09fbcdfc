; K counts repeats on Fanuc controls only.
G0 Z5
F100
G81 X1 Z-1 R2 K2
; expect: rapid Z5
; expect error 4:15 E4003
M30
