; A full circle: the end point is the start point, with or without end words.
G0 X10 Y0
; expect: rapid X10 Y0
G3 I-10 F100
; expect: arc ccw xy centre 0,0 F100
G2 X10 Y0 I-10 J0 P3
; expect: arc cw xy centre 0,0 turns 3 X10 Y0 F100
M30
; expect: end and rewind
