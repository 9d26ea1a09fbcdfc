(dialect fanuc)
#4001=1
; expect error 2:1 E3013
M30
