; channel lathe
; G71 cuts on levels of X up to the contour with its allowance, follows it, and goes on behind it; G70
; runs the contour itself.
G8 G94 F100 G0 X20 Z0
; expect: rapid X20 Z0
G71 U4 R1
G71 P10 Q30 U1
; expect: rapid X16
; expect: line Z-12.5 F100
; expect: line X17 Z-11.5 F100
; expect: rapid Z0
; expect: rapid X12
; expect: line Z-10.5 F100
; expect: line X13 Z-9.5 F100
; expect: rapid Z0
; expect: rapid X11
; expect: line Z-10 F100
; expect: line X21 Z-15 F100
; expect: rapid Z0
; expect: rapid X20
N10 G0 X10
N20 G1 Z-10 F50
N30 X20 Z-15
G70 P10 Q30
; expect: rapid X10
; expect: line Z-10 F50
; expect: line X20 Z-15 F50
; expect: rapid Z0
M30
; expect: end and rewind
