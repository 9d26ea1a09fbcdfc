; M19: the way P and the time limit Q; the speed stays, and the spindle stands afterwards.
S500 M3
; expect: spindle speed 500
; expect: spindle clockwise 500
M19 R-90 P2 Q5
; expect: spindle orient 500 R-90 counter-clockwise within 5
M19
; expect: spindle orient 500 R0
M19 P1 R30.5
; expect: spindle orient 500 R30.5 clockwise
M30
; expect: end and rewind
