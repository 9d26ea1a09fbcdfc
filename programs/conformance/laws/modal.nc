; Without axis words a law is modal: until #feedlaw (off), F, another feed mode or the end.
G1 F100 S_n=60 dS=0.1 dl=0.05
; expect: law linear S_n=60 dS=0.1 dl=0.05
X10
; expect: line X10 F60
X20 Smin=30 dS=1 dl=1 n_s=5
; expect: law modulated S_n=30 S_k=35 dS=1 dl=1 n_s=5 for the block
; expect: line X20 F30
#feedlaw (off)
; expect: law off
X30
; expect: line X30 F100
Smin=30 Smax=50 dS=0.5 dl=0.2
; expect: law modulated S_n=30 S_k=50 dS=0.5 dl=0.2 n_s=40
X40
; expect: line X40 F30
X50 F80
; expect: law off
; expect: line X50 F80
#feedlaw (off)
L_A=0.4 L_B=2
; expect: law interrupted L_A=0.4 L_B=2
X60
; expect: line X60 F80
L_A=0 L_B=2
; expect: law off
X60.5
; expect: line X60.5 F80
L_A=0.4 L_B=2
; expect: law interrupted L_A=0.4 L_B=2
X60.7 L_A=0 L_B=2
; expect: law off for the block
; expect: line X60.7 F80
S_n=60 dS=0.1 dl=0.05
; expect: law linear S_n=60 dS=0.1 dl=0.05
X61 L_A=0.4 L_B=2//F waits behind the law and is used again
; expect: law interrupted L_A=0.4 L_B=2 for the block
; expect: line X61 F80
X62
; expect: line X62 F60
G95 F0.2
; expect: law off
S_n=0.1 dS=0.002 dl=0.5
; expect: law linear S_n=0.1 dS=0.002 dl=0.5 per revolution
X70
; expect: line X70 F0.1 per revolution
M2
; expect: law off
; expect: end
