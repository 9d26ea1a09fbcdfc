G10 L3 P1 X0
; expect error 1:5 E4008
M30
