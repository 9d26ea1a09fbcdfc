(dialect fanuc A)
; channel lathe
; Fanuc B-64304EN-1, table 3.1: groups of G codes of lathes. G61 and G64 are of group 15, planes of 16.
G61 G98 F100.
G1 X#4015 Z#4016
; expect: line X30.5 Z18 F100 exact path
G64
X#4015
; expect: line X32 F100
M30
; expect: end and rewind
