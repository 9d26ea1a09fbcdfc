; I J lead to the first control point, P Q back from the end; the next curve goes on smoothly.
G0 X0 Y0
; expect: rapid X0 Y0
G5 I0 J3 P0 Q-3 X1 Y1 F100
; expect: spline 3 X1 Y1 (0 3) (1 -2) (1 1) F100
X2 Y2 P0 Q-3
; expect: spline 3 X2 Y2 (1 4) (2 -1) (2 2) F100
; A quadratic curve has one control point.
G5.1 X4 I1 J2
; expect: spline 2 X4 (3 4) (4 2) F100
; Distances are scaled and mirrored with the curve.
G51.1 X0
G91 G5 X1 I1 J1 P2 Q1
; expect: spline 3 X3 (3 3) (1 3) (3 2) F100
M30
; expect: end and rewind
