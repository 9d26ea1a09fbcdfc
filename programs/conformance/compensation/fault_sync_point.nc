; The program cannot wait for standstill while the end of an element depends on what follows.
F100 G0 X11 Y-9
; expect: rapid X11 Y-9
G42 D1 G1 X10 Y0
; expect: line X11 Y0 F100
Y10
; expect: line X11 Y10 F100
sync ();
; expect error 8:1 E4140
M30
