; M97 P L calls a block of this program, as on Haas controls; M99 P leaves for another block.
G0 X0
; expect: rapid X0
M97 P100 L2
; expect: rapid X1
; expect: rapid X2
; expect: rapid X1
; expect: rapid X2
M97 P200
X99
N50 X5
; expect: rapid Y1
; expect: rapid X5
M30
; expect: end and rewind
N100 X1
X2
M99
N200 Y1
M99 P50
