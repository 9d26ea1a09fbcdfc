G43.4 H1
; expect: tip H1 0 0 10
; expect: request sync
G68.2 J20 Z1
; expect: frame 1 X0 Y0 Z1 B0 C0 turned (1 0 0) (0 0.9396926208 -0.3420201433) (0 0.3420201433 0.9396926208)
G53.1
; expect error 6:1 E4301
M30
