(dialect fanuc)
; G10 (B-63944EN, 7.2.2 and 14.2): L2 and L20 offsets, L10 to L13 values of tools.
G90 G10 L2 P1 X10 Y20
; expect: request write offset channel 1 1 X 10
; expect: request write offset channel 1 1 Y 20
G10 L20 P1 Z5
; expect: request write offset channel 1 10 Z 5
G91 G10 L2 P2 X5
; expect: request write offset channel 1 2 X 105
G90
G10 L10 P3 R120.5
; expect: request write tool channel 1 3 length 120.5
G10 L11 P3 R-0.1
; expect: request write tool channel 5 3 wear_length -0.1
G10 L12 P3 R6
; expect: request write tool channel 4 3 radius 6
G10 L13 P3 R0.02
; expect: request write tool channel 6 3 wear_radius 0.02
G20
G10 L10 P3 R1
; expect: request write tool channel 1 3 length 25.4
M30
; expect: end and rewind
