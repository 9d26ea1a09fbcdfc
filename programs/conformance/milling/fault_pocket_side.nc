; The block does not say on which side of the outline the pocket lies.
G0 X8 Y5 Z5
; expect: rapid X8 Y5 Z5
G150 P20 Z-2 R1 Q2 J1.2 F100
; expect error 4:1 E4007
M30
O20
G1 Y0
X20
Y10
X0
Y0
X8
M99
