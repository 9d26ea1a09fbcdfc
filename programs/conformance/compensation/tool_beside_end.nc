; channel lathe
; T beside G40: the contour ends at the perpendicular of its last element, then the length goes, which
; makes Z-20 to Z0, then the move leads away, in X and Z. The same with G40 and T in blocks of their own,
; also where the numbers of the next point are those from before.
G8 G94 F100 T0201 G0 X20 Z10
; expect: prepare T2
; expect: change T2
; expect: length H2 0 0 20
; expect: rapid X20 Z10
G42.1 D0.8 L2 G1 X10 Z0
; expect: line X10 Z-0.4 F100
Z-20
; expect: line X10 Z-20 F100
X20
; expect: line X19.6 Z-20 F100
G40 G0 X30 T0200
; expect: prepare T2
; expect: change T2
; expect: length off
; expect: rapid X30 Z0
T0201
; expect: prepare T2
; expect: change T2
; expect: length H2 0 0 20
G42.1 D0.8 L2 G1 X10 Z-30
; expect: line X10 Z-30.4 F100
Z-40
; expect: line X10 Z-40 F100
X20
; expect: line X19.6 Z-40 F100
G40
T0200
; expect: prepare T2
; expect: change T2
; expect: length off
G0 X20 Z-40
; expect: rapid X20 Z-40
M30
; expect: end and rewind
