; O-lines behind `/` belong together with what is between them, skipped as well.
/ o<loop> repeat [2]
/ G0 X1
/ (a note)

/ G0 X2
/ o<loop> endrepeat
; expect: rapid X1
; expect: rapid X2
; expect: rapid X1
; expect: rapid X2
/2 o1 if [1 EQ 0]
/2 G0 X5
/2 o1 else
/2 G0 X6
/2 o1 endif
; expect: rapid X6
M30
; expect: end and rewind
