(dialect fanuc)
; G66 calls behind each block that moves, G66.1 in place of each block (B-63944EN, 16.6.2, 16.6.3).
G0
G66 P100 A5 L2
X1
; expect: rapid X1
; expect: rapid Z5
; expect: rapid Z6
; expect: rapid Z5
; expect: rapid Z6
M8
; expect: coolant flood
G1 Y2 F100
; expect: line Y2 F100
; expect: line Z5 F100
; expect: line Z6 F100
; expect: line Z5 F100
; expect: line Z6 F100
G67
G0 X3
; expect: rapid X3
G66.1 P200
X7 Z2
; expect: rapid Y7 Z2
X8
; expect: rapid Y8
G67
X4
; expect: rapid X4
; The arguments are set once: what the macro makes of them is there in the next call.
G66 P300 A5
X1
; expect: rapid X1
; expect: rapid Z6
X2
; expect: rapid X2
; expect: rapid Z7
G67
G66 P300 A1
X3
; expect: rapid X3
; expect: rapid Z2
G67
M30
; expect: coolant off
; expect: end and rewind
O100
Z#1
Z[#1+1]
M99
O200
Y#24 Z#26
M99
O300
#1=#1+1
Z#1
M99
