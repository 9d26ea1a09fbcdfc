; G87 on mills by the manual of Fanuc (back boring): over the hole the spindle stops at the angle of
; M19, the tool goes Q off the wall, to R behind the part, back to the middle, and bores up to Z.
; The same way out, always to the initial level.
F50 S1000 M19 R90
; expect: spindle speed 1000
; expect: spindle orient 1000 R90
M3
; expect: spindle clockwise 1000
G0 Z5
; expect: rapid Z5
G99 G87 X10 Z-18 R-25 Q0.3 P0.5
; expect: rapid X10
; expect: spindle orient 1000 R90
; expect: rapid Y-0.3
; expect: rapid Z-25
; expect: rapid Y0
; expect: spindle clockwise 1000
; expect: line Z-18 F50
; expect: dwell 0.5
; expect: spindle orient 1000 R90
; expect: rapid Y-0.3
; expect: rapid Z5
; expect: rapid Y0
; expect: spindle clockwise 1000
M30
; expect: spindle stop 0 $-1
; expect: end and rewind
