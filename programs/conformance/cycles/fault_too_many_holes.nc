; One block makes a bounded number of moves.
F100
G91 G81 X1 Z-1 R1 L1000000
; expect error 3:19 E4008
M30
