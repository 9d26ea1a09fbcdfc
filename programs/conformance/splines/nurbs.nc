; The point where the axes stand is the first of the curve; L is its order, P the weights.
G0 X10 Y0 F100
; expect: rapid X10 Y0
G5.2 P2 L4
X11 Y1 P3
X13
Y4 P0.5
G5.3
; expect: spline 3 X13 Y4 (11 1) (13 1) (13 4) w2 w3 w1 w0.5 F100
G91 G5.2 X1 Y1
X1 P2
Y1
G5.3
; expect: spline 2 X15 Y6 (14 5) (15 5) (15 6) w1 w1 w2 w1 F100
G0 X1
; expect: rapid X16
M30
; expect: end and rewind
