; What does not move in the plane keeps its place, and goes with the tool.
F100 G0 X0 Y0 Z5
; expect: rapid X0 Y0 Z5
G42 D2 M8
; expect: coolant flood
Z4
; expect: rapid Z4
G1 X10 Y0
; expect: line X10 Y-1 F100
M9
; expect: coolant off
Y20
; expect: arc ccw xy centre 10,0 X11 Y0 F100
Z3 B30
(MSG,here)
M0
; expect: line X11 Y20 F100
; expect: line Z3 B30 F100
; expect: message here
; expect: program stop
X0
; expect: arc ccw xy centre 10,20 X10 Y21 F100
; expect: line X0 Y21 F100
G40
Z5
; expect: line Z5 F100
M5
; expect: spindle stop 0
M1
; expect: optional stop
; expect: request sync
M30
; expect: end and rewind
