; G12 and G13 (Haas mill operator's manual): down at the centre, half a circle out, around, on by Q up
; to K, half a circle back. Tool 1 has the radius 1.
G0 X10 Y20 Z2
; expect: rapid X10 Y20 Z2
G13 I6 Z-3 D1 F200
; expect: line Z-3 F200
; expect: arc ccw xy centre 12.5,20 X15 Y20 F200
; expect: arc ccw xy centre 10,20 X15 Y20 F200
; expect: arc ccw xy centre 12.5,20 X10 Y20 F200
G0 Z2
; expect: rapid Z2
G12 I2 K5 Q2 Z-1 D0
; expect: line Z-1 F200
; expect: arc cw xy centre 11,20 X12 Y20 F200
; expect: arc cw xy centre 10,20 X12 Y20 F200
; expect: line X14 F200
; expect: arc cw xy centre 10,20 X14 Y20 F200
; expect: line X15 F200
; expect: arc cw xy centre 10,20 X15 Y20 F200
; expect: arc cw xy centre 12.5,20 X10 Y20 F200
G0 Z0
; expect: rapid Z0
G91 G13 I3 Z-1 L2 D0
; expect: line Z-1 F200
; expect: arc ccw xy centre 11.5,20 X13 Y20 F200
; expect: arc ccw xy centre 10,20 X13 Y20 F200
; expect: arc ccw xy centre 11.5,20 X10 Y20 F200
; expect: line Z-2 F200
; expect: arc ccw xy centre 11.5,20 X13 Y20 F200
; expect: arc ccw xy centre 10,20 X13 Y20 F200
; expect: arc ccw xy centre 11.5,20 X10 Y20 F200
M30
; expect: end and rewind
