; A vector needs a length.
G43.5 H2
; expect: tip H2 0 0 20
; expect: request sync
G1 X1 I0 J0 K0 F600
; expect error 5:7 E4355
M30
