; The axis whose word has the radius is that of the cylinder: B turns about Y, and an arc lies in the
; surface of B and Y, seen from outside: G3 turns from B to Y. A quarter of a circle of 10 mm is 10 mm
; around, an angle of 10/20 = 0.5 rad.
G7.1 B20
; expect: transformation cylinder 20 B
; expect: request sync
G1 Y0 B0 F100
; expect: line Y0 B0 F100
G3 Y10 B-28.64788975654 I-10 J0
; expect: arc ccw xy centre -10,0 Y10 B-28.64788976 F100
G7.1 B0
; expect: transformation off
; expect: request sync
M30
; expect: end and rewind
