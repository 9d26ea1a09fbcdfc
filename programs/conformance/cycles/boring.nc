; G86 stops the spindle for the way out, G89 dwells and feeds out.
S300 M4 G0 Z5
; expect: spindle speed 300
; expect: spindle counter-clockwise 300
; expect: rapid Z5
G86 X1 Z-2 R1 P0.2 F50
; expect: rapid X1
; expect: rapid Z1
; expect: line Z-2 F50
; expect: dwell 0.2
; expect: spindle stop 0
; expect: rapid Z5
; expect: spindle counter-clockwise 300
G89 X2
; expect: rapid X2
; expect: rapid Z1
; expect: line Z-2 F50
; expect: dwell 0.2
; expect: line Z1 F50
; expect: rapid Z5
M30
; expect: spindle stop 0 $-1
; expect: end and rewind
