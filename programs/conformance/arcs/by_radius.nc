; R is positive for less than half a turn and negative for more.
G3 X10 Y10 R10 F300
; expect: arc ccw xy centre 0,10 X10 Y10 F300
G2 X20 Y20 R10
; expect: arc cw xy centre 20,10 X20 Y20 F300
G2 X30 Y10 R-10
; expect: arc cw xy centre 30,20 X30 Y10 F300
G3 X50 Y10 R10
; expect: arc ccw xy centre 40,10 X50 Y10 F300
M30
; expect: end and rewind
