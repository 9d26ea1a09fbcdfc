(dialect fanuc)
#1=1.5 AND 2
M30
; expect error 2:4 E3009
