; #plane: the ways of G68.2 under names; values may be calculated.
#plane (spatial, 90, 0, 0)
; expect: frame 1 X0 Y0 Z0 B0 C0 turned (1 0 0) (0 0 -1) (0 1 0)
#plane (spatial, 45 + 45, 0, 90)
; expect: frame 1 X0 Y0 Z0 B0 C0 turned (0 0 1) (1 0 0) (0 1 0)
#plane (points, 10, 0, 0, 10, 5, 0, 10, 2, 7)
; expect: frame 1 X10 Y0 Z0 B0 C0 turned (0 0 1) (1 0 0) (0 1 0)
; Behind the values of the form X, Y and Z of its zero.
#plane (vectors, 0, 1, 0, 1, 0, 0, 1, 2, 3)
; expect: frame 1 X1 Y2 Z3 B0 C0 turned (0 0 1) (1 0 0) (0 1 0)
#plane (projected, 0, 90, 0)
; expect: frame 1 X0 Y0 Z0 B0 C0 turned (1 0 0) (0 0 -1) (0 1 0)
#plane (euler, 0, 90, 0, 10, 0, 0)
; expect: frame 1 X10 Y0 Z0 B0 C0 turned (1 0 0) (0 0 -1) (0 1 0)
#plane ()
; expect: frame 1 X0 Y0 Z0 B0 C0
M30
; expect: end and rewind
