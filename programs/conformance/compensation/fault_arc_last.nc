; The way from the parallel to the programmed point must be straight.
F100 G0 X11 Y-9
; expect: rapid X11 Y-9
G42 D1 G1 X10 Y0
; expect: line X11 Y0 F100
Y10
; expect: line X11 Y10 F100
G40
G3 X5 Y5 I-5
; expect error 9:1 E4143
M30
