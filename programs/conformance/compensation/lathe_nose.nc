; channel lathe
; The nose of radius 0.4 is left of the contour in ZX; orientation 2 lies at -X -Z of its centre, so
; that a cylinder and a face are where the program says.
G8 G94 F100 G0 X20 Z10
; expect: rapid X20 Z10
G42.1 D0.8 L2 G1 X10 Z0
; expect: line X10 Z-0.4 F100
Z-20
; expect: line X10 Z-20 F100
X20
; expect: line X19.6 Z-20 F100
G40 X30 Z10
; expect: line X30 Z10 F100
M30
; expect: end and rewind
