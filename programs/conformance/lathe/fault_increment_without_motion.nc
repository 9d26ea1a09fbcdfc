; channel lathe
G52 U5
M30
; expect error 2:5 E4302
