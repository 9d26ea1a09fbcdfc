; G10 L2 writes a work offset, L20 so that the point has the programmed coordinates.
G0 X5
; expect: rapid X5
G10 L2 P3 X7 Y8 R30
; expect: request write offset channel 1 3 X 7
; expect: request write offset channel 1 3 Y 8
; expect: request write offset channel 1 3 R 30
G10 L20 P0 X1
; expect: request write offset channel 1 1 X 4
G92 X0
; expect: frame 1 X5 Y0 Z0 B0 C0
; G92 stays on top of what is written.
G10 L20 P1 X1
; expect: request write offset channel 1 1 X -1
; L1 writes a row of the tool table.
G10 L1 P4 Z50.5 R3 I10 J20 Q2
; expect: request write tool channel 1 4 length 50.5
; expect: request write tool channel 4 4 radius 3
; expect: request write tool channel 9 4 angle_front 10
; expect: request write tool channel 10 4 angle_back 20
; expect: request write tool channel 8 4 orientation 2
; L10 the length with which the point has the programmed coordinates, L11 in G59.3.
G54 G92.1
; expect: frame 1 X0 Y0 Z0 B0 C0
G55
; expect: frame 2 X100 Y200 Z300 B0 C0
G43 H1 G0 Z0
; expect: length H1 0 0 10
; expect: rapid Z0
G10 L10 P1 Z-2 X1
; expect: request write tool channel 3 1 length_x -96
; expect: request write tool channel 1 1 length 12
G10 L11 P1 Z-2
; expect: request write tool channel 1 1 length 312
M30
; expect: end and rewind
