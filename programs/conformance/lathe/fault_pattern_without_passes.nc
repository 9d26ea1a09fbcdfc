; channel lathe
G73 P10 Q20 U1
N10 G0 X20
N20 G1 Z-10 F100
M30
; expect error 2:1 E4007
