; A law is part of the saved state, with the F that waits behind it.
F100 Smin=30 Smax=31 dS=0.1 dl=0.05
; expect: law modulated S_n=30 S_k=31 dS=0.1 dl=0.05 n_s=10
M70
string state = save_gvector (GV_FEED);
G1 X1 F50
; expect: law off
; expect: line X1 F50
M72
; expect: law modulated S_n=30 S_k=31 dS=0.1 dl=0.05 n_s=10
X2
; expect: line X2 F30
F50
; expect: law off
restore_gvector (state);
; expect: request sync
; expect: law modulated S_n=30 S_k=31 dS=0.1 dl=0.05 n_s=10
restore_gvector (state);//the same: it goes on
; expect: request sync
#feedlaw (off)
; expect: law off
X3
; expect: line X3 F100
M30
; expect: end and rewind
