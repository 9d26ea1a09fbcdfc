; The path turns back at X-10 Y0, and the tool stands between the arc and the line: it ends where the
; circle of radius 12 and the line at X-8 meet, at Y = sqrt (12^2 - 8^2). On the other side, with the
; line first, the same place.
F100 G0 X20 Y0 Z0
; expect: rapid X20 Y0 Z0
G42.1 D4 G1 X10 Y-5
; expect: line X12 Y-5 F100
Y0
; expect: line X12 Y0 F100
G3 X-10 Y0 I-10
; expect: arc ccw xy centre 0,0 X-8 Y8.94427191 F100
G1 Y20
; expect: line X-8 Y20 F100
G40 Y30
; expect: line X-10 Y30 F100
G41.1 D4 G1 X-10 Y20
; expect: line X-8 Y20 F100
Y0
; expect: line X-8 Y8.94427191 F100
G2 X10 Y0 I10
; expect: arc cw xy centre 0,0 X12 Y0 F100
G1 Y-5
; expect: line X12 Y-5 F100
G40 Y-20
; expect: line X10 Y-20 F100
; Two circles of radius 10 that touch at X10 Y0: the tool stands between them above, where circles of
; radius 12 about X0 and X20 meet, at Y = sqrt (12^2 - 10^2); from the right the same.
X-10
; expect: line X-10 F100
G41.1 D4 Y-10
; expect: line X-12 Y-10 F100
Y0
; expect: line X-12 Y0 F100
G2 X10 Y0 I10
; expect: arc cw xy centre 0,0 X10 Y6.633249581 F100
G2 X30 Y0 I10
; expect: arc cw xy centre 20,0 X32 Y0 F100
G1 Y-10
; expect: line X32 Y-10 F100
G40 Y-20
; expect: line X30 Y-20 F100
G42.1 D4 Y-10
; expect: line X32 Y-10 F100
Y0
; expect: line X32 Y0 F100
G3 X10 Y0 I-10
; expect: arc ccw xy centre 20,0 X10 Y6.633249581 F100
G3 X-10 Y0 I-10
; expect: arc ccw xy centre 0,0 X-12 Y0 F100
G1 Y-10
; expect: line X-12 Y-10 F100
G40 Y-20
; expect: line X-10 Y-20 F100
M30
; expect: end and rewind
