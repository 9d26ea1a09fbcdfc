(dialect fanuc)
G91 G10 L10 P1 R1
M30
; expect error 2:5 E4016
