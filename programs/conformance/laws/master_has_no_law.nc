; channel master
S_n=60 dS=0.1 dl=0.05
; expect error 2:1 E4009
M30
