; G90.1 takes the centre in the work offset, G91.1 from the start point.
G90.1 G1 X5 F100
; expect: line X5 F100
G3 X-5 Y0 I0 J0
; expect: arc ccw xy centre 0,0 X-5 Y0 F100
G91.1 X5 I5 J0
; expect: arc ccw xy centre 0,0 X5 F100
M30
; expect: end and rewind
