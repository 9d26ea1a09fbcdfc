; Between lines 2.1 apart a tool of radius 1 leaves material.
G0 X8 Y5 Z5
; expect: rapid X8 Y5 Z5
G150 P20 Z-2 R1 Q2 J2.1 G41 D1 F100
; expect error 4:1 E4069
M30
O20
G1 Y0
X20
Y10
X0
Y0
X8
M99
