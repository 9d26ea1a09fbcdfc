; Half a millimetre from the wall a tool of radius 1 cannot come down.
G0 X8 Y0.5 Z5
; expect: rapid X8 Y0.5 Z5
G150 P20 Z-2 R1 Q2 J1.2 G41 D1 F100
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
