; A saved feed mode comes back without the law: feeds of a law in the other unit mean nothing.
string state = save_gvector (GV_MODAL);
G95 S_n=0.1 dS=0.002 dl=0.5
; expect: law linear S_n=0.1 dS=0.002 dl=0.5 per revolution
restore_gvector (state);
; expect: request sync
; expect: law off
G0 X1
; expect: rapid X1
M30
; expect: end and rewind
