; The angle counts from the first to the second axis of the plane: Z to X, Y to Z.
G18 G68 X0 Z0 R90
; expect: frame 1 X0 Y0 Z0 B0 C0 turned (0 0 1) (0 1 0) (-1 0 0)
G19 G68 Y0 Z0 R90
; expect: frame 1 X0 Y0 Z0 B0 C0 turned (1 0 0) (0 0 -1) (0 1 0)
; About the space diagonal a third of a turn takes X to Y, Y to Z and Z to X.
G17 G68 X0 Y0 Z0 I1 J1 K1 R120
; expect: frame 1 X0 Y0 Z0 B0 C0 turned (0 0 1) (1 0 0) (0 1 0)
G69
; expect: frame 1 X0 Y0 Z0 B0 C0
M30
; expect: end and rewind
