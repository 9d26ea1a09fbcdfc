(dialect fanuc)
; A negative factor mirrors about the centre (B-64304EN-2, "mirror image" of G51); of one axis in the
; plane it exchanges the directions of arcs.
G51 X4 Y0 I-1. J1.
G1 X20 Y5 F100
; expect: line X-12 Y5 F100
G2 X24 Y9 I4 J0
; expect: arc ccw xy centre -16,5 X-16 Y9 F100
G51 X0 Y0 P-2.
G1 X3 Y4
; expect: line X-6 Y-8 F100
G3 X4 Y3 I-3 J-4
; expect: arc ccw xy centre 0,0 X-8 Y-6 F100
G50
G1 X1
; expect: line X1 F100
M30
; expect: end and rewind
