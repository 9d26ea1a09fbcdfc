; The radii at start and end may differ by 0.01 mm.
F100 G2 X20.009 Y0 I10
; expect: arc cw xy centre 10,0 X20.009 Y0 F100
N7 G3 X0.2 I-10
; expect error 4:4 E4032
M30
