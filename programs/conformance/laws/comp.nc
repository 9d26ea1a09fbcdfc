; Under radius compensation the law stands before the parallel of its own block; the arc about the
; corner before it runs at the first feed of the law.
T1 M6
; expect: prepare T1
; expect: change T1
G41 D1 G1 X10 F100
G1 X20 S_n=60 dS=0.1 dl=0.05
; expect: line X10 Y1 F100
Y-10 S_n=40 dS=0.1 dl=0.05
; expect: law linear S_n=60 dS=0.1 dl=0.05 for the block
; expect: line X20 Y1 F60
; expect: arc cw xy centre 20,0 X21 Y0 F40
Smin=30 n_s=10 dS=0.1 dl=0.05
Z-1 S_n=20 dS=0.1 dl=0.05
X10 
; expect: law linear S_n=40 dS=0.1 dl=0.05 for the block
; expect: line X21 Y-10 F40
; expect: law modulated S_n=30 S_k=31 dS=0.1 dl=0.05 n_s=10
; expect: law linear S_n=20 dS=0.1 dl=0.05 for the block
; expect: line Z-1 F20
; expect: arc cw xy centre 20,-10 X20 Y-11 F30
G40
; expect: line X10 Y-11 F30
X0 S_n=20 dS=0.1 dl=0.05
; expect: law linear S_n=20 dS=0.1 dl=0.05 for the block
; expect: line X0 Y-10 F20
M30
; expect: law off
; expect: end and rewind
