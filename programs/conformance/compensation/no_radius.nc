; A tool without a radius runs on the contour itself, which may begin and end with an arc.
G41.1 D0 F100
G2 X10 I5
; expect: arc cw xy centre 5,0 X10 F100
G1 X20
; expect: line X20 F100
G3 X30 I5
; expect: arc ccw xy centre 25,0 X30 F100
G40
G2 X20 I-5
; expect: arc cw xy centre 25,0 X20 F100
M30
; expect: end and rewind
