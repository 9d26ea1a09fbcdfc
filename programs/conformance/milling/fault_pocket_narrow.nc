; Run clockwise with G42; the slot at its end, 1 mm wide, is too narrow for a tool of radius 1.
G0 X5 Y5 Z5
; expect: rapid X5 Y5 Z5
G150 P20 Z-2 R1 Q2 I1 G42 D1 F100
; expect error 4:1 E4069
M30
O20
G1 Y0
X0
Y10
X10
Y6
X20
Y5
X10
Y0
X5
M99
