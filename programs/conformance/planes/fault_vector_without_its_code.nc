; Beside G1 a vector belongs to G43.5.
G43.4 H2
; expect: tip H2 0 0 20
; expect: request sync
G1 X1 K1 F600
; expect error 5:7 E4003
M30
