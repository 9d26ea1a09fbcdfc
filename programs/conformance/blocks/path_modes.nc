; G9 holds for its block, G61, G61.1 and G64 until the next of them.
G61 G0 X1
; expect: rapid X1 exact path
G61.1 X2
; expect: rapid X2 exact stop
G64 P0.05 X3
; expect: rapid X3 tolerance 0.05
G9 X4
; expect: rapid X4 stop tolerance 0.05
G64
X5
; expect: rapid X5
M30
; expect: end and rewind
