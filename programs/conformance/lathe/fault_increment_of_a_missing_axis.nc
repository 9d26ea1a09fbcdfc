; channel lathe
G0 V5
M30
; expect error 2:4 E4010
