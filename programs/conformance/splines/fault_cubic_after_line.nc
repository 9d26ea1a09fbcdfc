G5 X1 Y1 I1 J1 P1 Q1 F100
G1 X2
G5 X3 P1 Q1
M30
; expect: spline 3 X1 Y1 (1 1) (2 2) (1 1) F100
; expect: line X2 F100
; expect error 3:1 E4007
