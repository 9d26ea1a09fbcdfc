; The angles follow from the vector.
G43.5 H2
; expect: tip H2 0 0 20
; expect: request sync
G1 X1 B20 K1 F600
; expect error 5:11 E4355
M30
