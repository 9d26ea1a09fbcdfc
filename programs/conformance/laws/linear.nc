; A law beside axis words is one of its block; F stays what it was.
G1 X100 S_n=60 dS=0.1 dl=0.05
; expect: law linear S_n=60 dS=0.1 dl=0.05 for the block
; expect: line X100 F60
F200
X0 s_n=60 ds=0.5 DL=-0.2
; expect: law linear S_n=60 dS=-0.5 dl=0.2 for the block
; expect: line X0 F60
X50
; expect: line X50 F200
G2 X50 I5 S_n=100 S_k=40 dS=0.2//dl follows from the length of the circle
; expect: law linear S_n=100 S_k=40 dS=-0.2 for the block
; expect: arc cw xy centre 55,0 X50 F100
G1 X60 S_n=40 S_k=100 dS=0.2 dl=0.01
; expect: law linear S_n=40 S_k=100 dS=0.2 dl=0.01 for the block
; expect: line X60 F40
X70 S_n=40 S_k=40 dS=0.2 dl=0.01
; expect: law linear S_n=40 S_k=40 dl=0.01 for the block
; expect: line X70 F40
G5.1 X80 Y5 I5 J0 S_n=50 dS=0.1 dl=0.1
; expect: law linear S_n=50 dS=0.1 dl=0.1 for the block
; expect: spline 2 X80 Y5 (75 0) (80 5) F50
M30
; expect: end and rewind
