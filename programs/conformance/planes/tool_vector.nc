; G43.5: I, J and K beside G0 and G1 say where the tool points at the end of the move, from its tip
; into the spindle. Here the tool points to (sin B cos C, -sin B sin C, cos B).
G43.5 H2
; expect: tip H2 0 0 20
; expect: request sync
G0 X1 I1 K1
; expect: rapid X1 B45 C0
; Its length does not count, and without a vector the tool keeps its direction.
Y2 J-20 K20
; expect: rapid Y2 B45 C90
G1 X3 F600
; expect: line X3 F600
; A vector alone moves, too, by the modal motion, at feed on the great circle: here B alone turns in
; the plane of both directions. Upright, C stays where it is.
K1
; expect: line B0 C90 F600
; In the frame of the programmed coordinates: with a tilted plane, in the plane.
G68.2 I90 J90
; expect: frame 1 X0 Y0 Z0 B0 C0 turned (0 0 1) (1 0 0) (0 1 0)
G0 K1
; expect: rapid B90 C0
G69
; expect: frame 1 X0 Y0 Z0 B0 C0
; Rotary words are taken where no vector is.
G0 B10 C20
; expect: rapid B10 C20
G49
; expect: length off
; expect: request sync
M30
; expect: end and rewind
