; G76 stops the spindle at the angle of M19, leaves the wall by Q away from the edge, and goes out.
G18 F50 S1000 M19 R90
; expect: spindle speed 1000
; expect: spindle orient 1000 R90
M3
; expect: spindle clockwise 1000
G76 Z5 Y-10 R1 Q0.3
; expect: rapid Y1
; expect: rapid Z5
; expect: line Y-10 F50
; expect: spindle orient 1000 R90
; expect: rapid X-0.3
; expect: rapid Y1
; expect: rapid X0
; expect: spindle clockwise 1000
M30
; expect: spindle stop 0 $-1
; expect: end and rewind
