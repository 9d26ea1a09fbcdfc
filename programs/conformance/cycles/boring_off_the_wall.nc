(dialect haas)
; Haas mill operator's manual, G76 and G77: I and J are the way off the wall, Q is another one. G77
; bores from behind. M19 P90 stops the spindle at 90 degrees.
F50 S1000 M19 P90
; expect: spindle speed 1000
; expect: spindle orient 1000 R90
M3
; expect: spindle clockwise 1000
G0 Z5
; expect: rapid Z5
G98 G76 X10 Z-8 R2 I0.2 J-0.1
; expect: rapid X10
; expect: rapid Z2
; expect: line Z-8 F50
; expect: spindle orient 1000 R90
; expect: rapid X10.2 Y-0.1
; expect: rapid Z5
; expect: rapid X10 Y0
; expect: spindle clockwise 1000
G77 X20 Z-18 R-25 Q0.3
; expect: rapid X20
; expect: spindle orient 1000 R90
; expect: rapid X20.2 Y-0.1
; expect: rapid Z-25
; expect: rapid X20 Y0
; expect: spindle clockwise 1000
; expect: line Z-18 F50
; expect: spindle orient 1000 R90
; expect: rapid X20.2 Y-0.1
; expect: rapid Z5
; expect: rapid X20 Y0
; expect: spindle clockwise 1000
G80
M30
; expect: spindle stop 0 $-1
; expect: end and rewind
