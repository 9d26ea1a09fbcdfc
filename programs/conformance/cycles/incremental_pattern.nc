; In G91 R counts from the initial level and Z from R; L makes a row of holes.
G0 Z10
; expect: rapid Z10
G91 G81 X10 Z-4 R-8 L3 F100
; expect: rapid X10
; expect: rapid Z2
; expect: line Z-2 F100
; expect: rapid Z10
; expect: rapid X20
; expect: rapid Z2
; expect: line Z-2 F100
; expect: rapid Z10
; expect: rapid X30
; expect: rapid Z2
; expect: line Z-2 F100
; expect: rapid Z10
L0 X5
G80
M30
; expect: end and rewind
