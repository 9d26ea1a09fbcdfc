; In G18 the plane is Z X: K and I, P along Z and Q along X. In G19 it is Y Z: J and K.
G18 G5 Z1 X2 K0 I3 P-1 Q-4 F100
; expect: spline 3 X2 Z1 (0 3) (0 -2) (1 2) ZX F100
G19 G5.1 Y4 Z3 J2 K5
; expect: spline 2 Y4 Z3 (2 6) (4 3) YZ F100
G18 G5.2 P1 L3
Z5 X3 P2
X4
G5.3
; expect: spline 2 X4 Z5 (5 3) (5 4) w1 w2 w1 ZX F100
G19 G6.2 P2 K0 Y4 Z5
K0 Y6 Z7
K1
K1
; expect: spline 1 Y6 Z7 (6 7) w1 w1 YZ F100
M30
; expect: end and rewind
