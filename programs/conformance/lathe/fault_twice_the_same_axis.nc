; channel lathe
G0 X10 U5
M30
; expect error 2:8 E4001
