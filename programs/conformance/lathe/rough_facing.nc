; channel lathe
; G72 cuts along X on levels of Z; W is the depth of cut in the first block, an allowance in the second.
G8 G94 F100 G0 X20 Z2
; expect: rapid X20 Z2
G72 W2 R0.5
G72 P1 Q2 W0.5
; expect: rapid Z0
; expect: line X5 F100
; expect: line X5.5 Z0.5 F100
; expect: rapid X20
; expect: rapid Z-2
; expect: line X5 F100
; expect: line X5.5 Z-1.5 F100
; expect: rapid X20
; expect: rapid Z-2.5
; expect: line X5 F100
; expect: rapid Z2
; expect: rapid X20
N1 G0 Z-3
N2 G1 X5
M30
; expect: end and rewind
