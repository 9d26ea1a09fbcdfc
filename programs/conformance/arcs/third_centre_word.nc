(dialect haas)
; Posts write I, J and K for every arc: of the third word 0 says nothing.
G0 X0 Y0 F100
; expect: rapid X0 Y0
G2 X10 Y0 I5 J0 K0
; expect: arc cw xy centre 5,0 X10 Y0 F100
G2 X20 Y0 I5 J0 K1
; expect error 7:17 E4030
M30
