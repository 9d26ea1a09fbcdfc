(dialect linuxcnc)
; channel lathe
; The text has no subprogram of that number.
F100
G71 Q7 I1
; expect error 5:1 E4068
M2
