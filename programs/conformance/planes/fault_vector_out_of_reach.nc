; B ends at 100 deg; from below the part is out of reach.
G43.5 H2
; expect: tip H2 0 0 20
; expect: request sync
G1 X1 K-1 F600
; expect error 5:7 E4354
M30
