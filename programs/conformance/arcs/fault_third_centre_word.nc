; Outside of the dialects of Fanuc and Haas it is an error, as on LinuxCNC.
G0 X0 Y0 F100
; expect: rapid X0 Y0
G2 X10 Y0 I5 J0 K0
; expect error 4:17 E4030
M30
