; Farther away than any machine reaches: refused before it is computed.
G0 X5 Y5 Z5
; expect: rapid X5 Y5 Z5
G150 P20 Z-4 R1 Q2 I1 G41 D1 F100
; expect error 4:1 E4069
M30
O20
G1 Y0
X1000000
Y10
X0
Y0
X5
M99
