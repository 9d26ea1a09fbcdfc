(dialect haas A)
; channel lathe
; Haas lathe operator's manual, "Corner rounding and chamfering": A, C and R need no comma, I is a
; chamfer behind a move of Z, K behind one of X; their sign says where the next move goes. I of
; G75 is a peck.
G98 F100.
G0 X20. Z0.
; expect: rapid X10 Z0
G1 X30. K-1.
; expect: line X14 Z0 F100
; expect: line X15 Z-1 F100
Z-20. I2.
; expect: line X15 Z-18 F100
; expect: line X17 Z-20 F100
X50. R-3.
; expect: line X22 Z-20 F100
; expect: arc ccw zx centre -23,22 X25 Z-23 F100
Z-40.
; expect: line Z-40 F100
G75 X48. I1.
; expect: line X24 F100
; expect: rapid X25
M30
; expect: end and rewind
