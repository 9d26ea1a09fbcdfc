; G53.6 may follow G43.4, G53.1 may not: what it does to the tip is no part of G43.4.
G43.4 H1
; expect: tip H1 0 0 10
; expect: request sync
G68.2 I90 J90
; expect: frame 1 X0 Y0 Z0 B0 C0 turned (0 0 1) (1 0 0) (0 1 0)
G53.6
; expect: rapid B90 C0
G53.1
; expect error 9:1 E4301
M30
