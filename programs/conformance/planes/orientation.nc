; #orientation: how the tool turns in a move at feed. Here it points to
; (sin B cos C, -sin B sin C, cos B). Of itself G43.5 goes on the great circle, G43.4 evenly.
G43.5 H2
; expect: tip H2 0 0 20
; expect: request sync
G0 X1 I1 K1
; expect: rapid X1 B45 C0
#orientation (axis)
G1 X3 J-1 K1 F600
; expect: line X3 B45 C90 F600
G49
; expect: length off
; expect: request sync
; On the circle from B30 to B60 B alone turns.
G43.4 H2
; expect: tip H2 0 0 20
; expect: request sync
G0 X1 B30 C90
; expect: rapid X1 B30 C90
#orientation (vector)
G1 X3 B60 F600
; expect: line X3 B60 C90 F600
; #orientation () lets the axes move evenly again.
#orientation ()
X7 B45 C0
; expect: line X7 B45 C0 F600
G49
; expect: length off
; expect: request sync
M30
; expect: end and rewind
