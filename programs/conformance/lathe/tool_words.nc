; channel lathe
; The last two digits are the edge; edge 00 is the tool without its offset.
G94 G0 Z100
; expect: rapid Z100
T0201
; expect: prepare T2
; expect: change T2
; expect: length H2 0 0 20
T0200
; expect: prepare T2
; expect: change T2
; expect: length off
G91 G0 Z1
; expect: rapid Z101
M61 Q4
; expect: set T4
T0102
; expect error 17:1 E5021
M30
