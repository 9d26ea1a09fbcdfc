; A wall that the tool cannot touch: the arc before it keeps it away.
F100 G0 X-20
; expect: rapid X-20
G41.1 D18 G1 X0
; expect: line X0 Y9 F100
G3 X0 Y20 J10
; expect: arc ccw xy centre 0,10 X0 Y11 F100
G1 Y5
; expect error 8:1 E4146
M30
