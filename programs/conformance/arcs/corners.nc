; A rounding touches both moves, a chamfer begins and ends at its size from the corner.
G1 X20 ,R5 F300
Y20 ,C2
; expect: line X15 Y0 F300
; expect: arc ccw xy centre 15,5 X20 Y5 F300
X0
; expect: line X20 Y18 F300
; expect: line X18 Y20 F300
; expect: line X0 F300
; 30 mm beside the line X-20, and 50 mm from the centre -20,20: three to four to five.
G2 X-20 Y0 R20 ,R30
G1 Y-40
; expect: arc cw xy centre -20,20 X-8 Y4 F300
; expect: arc ccw xy centre 10,-20 X-20 Y-20 F300
; expect: line Y-40 F300
M30
; expect: end and rewind
