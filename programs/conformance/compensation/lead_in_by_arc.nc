; An arc leads in from where the tool is to the perpendicular at its end. Expected: rs274 of
; LinuxCNC 2.9.
F100
G0 X0 Y-10
; expect: rapid X0 Y-10
G41.1 D4
G3 X10 Y0 I0 J10
; expect: arc ccw xy centre -2.25,0 X8 Y0 F100
G1 Y20
; expect: line X8 Y20 F100
G40 X0
; expect: line X0 Y20 F100
; Inside corner.
G0 X0 Y-10
; expect: rapid X0 Y-10
G42.1 D4
G3 X10 Y0 I0 J10
G1 X20
; expect: arc ccw xy centre 1.833333333,0 X11.8013377 Y-2 F100
Y10
; expect: line X20 Y-2 F100
; expect: arc ccw xy centre 20,0 X22 Y0 F100
G40 Y30
; expect: line X22 Y10 F100
; expect: line X20 Y30 F100
; Outside corner.
G0 X0 Y0
; expect: rapid X0 Y0
G41.1 D2
G3 X10 Y0 I5 J0
G1 X12
; expect: arc ccw xy centre 4.5,0 X9 Y0 F100
; expect: arc cw xy centre 10,0 X10 Y1 F100
G40 Y30
; expect: line X12 Y1 F100
; expect: line X12 Y30 F100
M30
; expect: end and rewind
