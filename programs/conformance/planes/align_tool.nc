; G53.1 turns the rotary axes only; from there on the coordinates are those of the tool tip.
G43 H2
; expect: length H2 0 0 20
G68.2 I90 J90
; expect: frame 1 X0 Y0 Z0 B0 C0 turned (0 0 1) (1 0 0) (0 1 0)
G53.1
; expect: rapid B90 C0
; expect: tip H2 0 0 20
; expect: request sync
G0 X1 Y2 Z3
; expect: rapid X1 Y2 Z3
; Another length, and none, are lengths along the tool.
G43 H3
; expect: tip H3 0 0 30
; expect: request sync
G49
; expect: tip H0 0 0 0
; expect: request sync
; The other branch.
G53.1 P2
; expect: length off
; expect: request sync
; expect: rapid B-90 C180
; expect: tip H0 0 0 0
; expect: request sync
G69
; expect: frame 1 X0 Y0 Z0 B0 C0
; expect: length off
; expect: request sync
; G53.6 keeps the tip where it is: its mode comes first.
G43 H2
; expect: length H2 0 0 20
G68.2 I90 J90
; expect: frame 1 X0 Y0 Z0 B0 C0 turned (0 0 1) (1 0 0) (0 1 0)
G53.6 P1
; expect: tip H2 0 0 20
; expect: request sync
; expect: rapid B90 C0
; A new plane begins without alignment.
G68.2 I0 J0
; expect: frame 1 X0 Y0 Z0 B0 C0
; expect: length H2 0 0 20
; expect: request sync
G69
; Under G43.4 the tip is led anyhow. At the pole C stays.
G0 C33
; expect: rapid C33
G43.4 H2
; expect: tip H2 0 0 20
; expect: request sync
G68.2 Z5
; expect: frame 1 X0 Y0 Z5 B0 C0
G53.6
; expect: rapid B0 C33
M30
; expect: end and rewind
