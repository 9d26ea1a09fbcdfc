(dialect fanuc)
; Vacant variables (B-63944EN, 16.1): as 0 in computations, equal only to each other; a word of one
; is left out.
G90 G0 X1 Y1 F100
; expect: rapid X1 Y1
IF [#1 EQ #0] THEN X2
; expect: rapid X2
IF [#1 EQ 0] THEN X99
IF [#1 NE 0] THEN X3
; expect: rapid X3
IF [#1 LT 1] THEN X4
; expect: rapid X4
IF [#1 GE #0] THEN X5
; expect: rapid X5
X#1 Y5
; expect: rapid Y5
X[#1] Y-#1 Z1
; expect: rapid Z1
X[#1+1]
; expect: rapid X1
#2=#1
IF [#2 EQ #0] THEN X6
; expect: rapid X6
#2=#1*5
IF [#2 EQ 0] THEN X7
; expect: rapid X7
#3=10
#3=#0
IF [#3 EQ #0] THEN X8
; expect: rapid X8
G65 P200 A1 C3
; expect: rapid X1
; expect: rapid Z3
M30
; expect: end and rewind
O200
X#1
IF [#2 NE #0] THEN Y98
Z#3
M99
