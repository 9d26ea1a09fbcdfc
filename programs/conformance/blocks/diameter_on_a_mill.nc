; G7 makes X a diameter, absolute and incremental, but no radius, no centre and no other axis.
G7 G0 X20 Y20
; expect: rapid X10 Y20
G91 X4 Y4
; expect: rapid X12 Y24
G90 G17 F100 G3 X24 Y32 I0 J4
; expect: arc ccw xy centre 12,28 X12 Y32 F100
G8 G1 X10
; expect: line X10 F100
M30
; expect: end and rewind
