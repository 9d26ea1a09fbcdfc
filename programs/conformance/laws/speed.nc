; Feed and speed of the spindle step at the same points of the path.
S500 M3 G1 X10 n_n=500 dn=-2 S_n=60 dS=0.1 dl=0.05
; expect: spindle speed 500
; expect: spindle clockwise 500
; expect: law linear S_n=60 dS=0.1 dl=0.05 n_n=500 step -2 for the block
; expect: line X10 F60
X20 n_n=500 n_k=800 S_n=60 S_k=90 dS=0.1
; expect: law linear S_n=60 S_k=90 dS=0.1 n_n=500 to 800 for the block
; expect: line X20 F60
X30 n_n=500 n_k=800 S_n=60 S_k=60 dS=0.1 dl=0.5
; expect: law linear S_n=60 S_k=60 dl=0.5 n_n=500 to 800 for the block
; expect: line X30 F60
v_n=120 dv=0 S_n=60 dS=0.1 dl=0.05
; expect: law linear S_n=60 dS=0.1 dl=0.05 v_n=120
G20 X2 v_n=100 v_k=200 S_n=10 S_k=5 dS=0.5//inch, inch/min and ft/min
; expect: law linear S_n=254 S_k=127 dS=-12.7 v_n=30.48 to 60.96 for the block
; expect: line X50.8 F254
M30
; expect: law off
; expect: spindle stop 0 $-1
; expect: end and rewind
