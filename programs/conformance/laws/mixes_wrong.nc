; What fits no law is found when the program is loaded, with the address that is missing or too many.
G1 X1 S_n=60 dS=0.1
; expect error 2:7 E4330
X2 Smin=60 Smax=70 dS=1 dl=1 n_s=10
; expect error 4:12 E4331
X3 L_A=1 L_B=2 S_n=60
; expect error 6:16 E4332
G0 X4 L_A=1 L_B=2
; expect error 8:7 E4333
G1 G28 X5 S_n=60 dS=1 dl=1
; expect error 10:4 E4006
#feedlaw (linear, 60, 0.1)
; expect error 12:1 E3005
#feedlaw (lineal, 60, 0.1, 1)
; expect error 14:11 E3023
#feedlaw (curve, 60, 0.1)
; expect error 16:18 E3004
#feedlaw (off, 1)
; expect error 18:1 E3005
#feedlaw
; expect error 20:9 E2001
X1 SPOS=90
; expect error 22:4 E2090
dl=1 dl=2
; expect error 24:6 E4001
M30
