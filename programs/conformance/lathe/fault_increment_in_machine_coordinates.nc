; channel lathe
G53 G0 U5
M30
; expect error 2:1 E4042
