; channel lathe
; Pockets behind a contour that goes back cannot be cut on levels.
G94 F100 G0 X40 Z1
; expect: rapid X20 Z1
G71 U1 R0.5
G71 P10 Q30
; expect error 6:1 E4068
N10 G0 X10
N20 G1 Z-10
N30 Z-8 X20
M30
