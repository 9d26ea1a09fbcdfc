; A line without end directly behind a chamfer: it goes up from (10,0), and meets the line that ends
; at (0,20) under 135 deg in (10,10). The chamfer takes 2 mm of both.
G1 X10 ,C2 F100
; expect: line X8 Y0 F100
,A90
; expect: line X10 Y2 F100
X0 Y20 ,A135
; expect: line X10 Y10 F100
; expect: line X0 Y20 F100
M30
; expect: end and rewind
