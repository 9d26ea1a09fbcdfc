; Mirror, then scaling, then rotation.
G0 X10 Y0
; expect: rapid X10 Y0
G51.1 X20
msg (str ($prog_pos[X]));
; expect: message 30
X25 Y1
; expect: rapid X15 Y1
G91 X-1
; expect: rapid X16
; One mirrored axis exchanges the directions of arcs; two do not.
G90 G2 X24 Y3 J1 F100
; expect: arc ccw xy centre 16,2 X16 Y3 F100
G51.1 Y0
G3 X24 Y-5 R1
; expect: arc ccw xy centre 16,4 X16 Y5 F100
; Only the axis named is mirrored no more.
G50.1 Y1
G1 X24 Y7
; expect: line X16 Y7 F100
; The mirror comes first: 24 becomes 16, scaling by 2 about the mirrored 24 leaves it.
G51 X24 Y7 P2
X23 Y8
; expect: line X18 Y9 F100
G68 X24 Y7 R90
; expect: frame 1 X23 Y-9 Z0 B0 C0 turned (0 -1 0) (1 0 0) (0 0 1)
G50 G50.1 G69
; expect: frame 1 X0 Y0 Z0 B0 C0
X1
; expect: line X1 F100
M30
; expect: end and rewind
