; A rotation would turn the vector, too; this is not done.
G43.5 H2
; expect: tip H2 0 0 20
; expect: request sync
G68 X0 Y0 R30
; expect: frame 1 X0 Y0 Z0 B0 C0 turned (0.8660254038 -0.5 0) (0.5 0.8660254038 0) (0 0 1)
G1 X1 K1 F600
; expect error 7:1 E4301
M30
