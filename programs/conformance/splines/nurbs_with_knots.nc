; G6.2 (B-63944EN, NURBS interpolation): control points with knots and weights, then the last knots.
; A curve with knots is one spline for each of its Bezier curves. Expected: a quarter of a circle is
; one of them (Piegl and Tiller, 7.3); of a curve of order 3 the knot in its middle makes two, which
; meet halfway between both middle points.
G0 X10 Y0 F100
; expect: rapid X10 Y0
G6.2 P3 K0 X10 Y0
K0 X10 Y10 R0.5
K0 X0 Y10
K1
K1
K1
; expect: spline 2 X0 Y10 (10 10) (0 10) w1 w0.5 w1 F100
G91
G6.2 P3 X0 Y0 K0 Q1
X4 K0
Y8 K0
X4 K1
K2
K2 F200
K2
; expect: spline 2 X4 Y14 (4 10) (4 14) w1 w1 w1 F200
; expect: spline 2 X8 Y18 (4 18) (8 18) w1 w1 w1 F200
; Order 4 without P: knots 0 0 0 0 1 1 1 1 are a Bezier curve.
G90
G6.2 X8 Y18 K0
X9 Y19 K0
X10 Y19 K0
X11 Y18 K0
G6.2 K1
G6.2 K1
G6.2 K1
G6.2 K1
; expect: spline 3 X11 Y18 (9 19) (10 19) (11 18) w1 w1 w1 w1 F200
G1 X0
; expect: line X0 F200
M30
; expect: end and rewind
