(dialect fanuc)
#34=1
; expect error 2:1 E3015
M30
