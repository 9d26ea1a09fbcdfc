; No move but lines and arcs in the plane.
G0 X5 Y5 Z5
; expect: rapid X5 Y5 Z5
G150 P20 Z-2 R1 Q2 I1 G41 D1 F100
; expect error 4:1 E4069
M30
O20
G1 Y0
X10
Y10 Z-1
X0
Y0
X5
M99
