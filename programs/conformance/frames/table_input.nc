; G10 L2 writes a work offset, L20 so that the point has the programmed coordinates.
G0 X5
; expect: rapid X5
G10 L2 P3 X7 Y8
; expect: request write offset 3 X 7
; expect: request write offset 3 Y 8
G10 L20 P0 X1
; expect: request write offset 1 X 4
M30
; expect: end and rewind
