; G41: the tool of radius 1 runs on the left, outside of a clockwise square. The lead-in ends on the
; perpendicular of the first side; outside corners are arcs; without a lead-out the last
; side ends on its perpendicular, and the way from there is the block after G40.
T1 M6 G0 X-10 Y-5 F100
; expect: prepare T1
; expect: change T1
; expect: rapid X-10 Y-5
G41 G1 X0 Y0
; expect: line X-1 Y0 F100
Y20
; expect: line X-1 Y20 F100
X20 F200
; expect: arc cw xy centre 0,20 X0 Y21 F200
; expect: line X20 Y21 F200
G0 Y0
; expect: arc cw xy centre 20,20 X21 Y20 F200
; expect: rapid X21 Y0
G1 X0
; expect: arc cw xy centre 20,0 X20 Y-1 F200
; expect: line X0 Y-1 F200
G40 G0 X-10
; expect: rapid X-10 Y0
X-20
; expect: rapid X-20
M30
; expect: end and rewind
