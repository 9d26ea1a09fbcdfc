; channel lathe
G17 G68 X0 R30
; expect error 2:5 E4306
M30
