; The outline ends where it does not begin.
G0 X8 Y5 Z5
; expect: rapid X8 Y5 Z5
G150 P20 Z-2 R1 Q2 I1 G41 D1 F100
; expect error 4:1 E4069
M30
O20
G1 Y0
X20
Y10
X0
M99
