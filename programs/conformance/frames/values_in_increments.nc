; G91 makes ways of motions only: shifts, their names for a point and table rows stay absolute.
G91 G0 X10
; expect: rapid X10
G52 X5
; expect: frame 1 X5 Y0 Z0 B0 C0
G52 X5
X1
; expect: rapid X6
G92 X2
; expect: frame 1 X9 Y0 Z0 B0 C0
G92 X2
X1
; expect: rapid X3
G10 L2 P3 X7
; expect: request write offset channel 1 3 X 7
T1 M6 G43.1 Z4
; expect: prepare T1
; expect: change T1
; expect: length H1 0 0 4
G43.1 Z4
M30
; expect: end and rewind
