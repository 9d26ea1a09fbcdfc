(dialect fanuc)
M98 <SUB>
; expect error 2:5 E2001
#1=POW[2]
; expect error 4:9 E2001
#1=POW[2][3]
; expect error 6:9 E2001
M30
