; channel lathe
G68.2 J10
; expect error 2:1 E4306
M30
