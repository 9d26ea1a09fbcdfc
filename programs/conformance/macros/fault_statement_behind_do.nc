(dialect fanuc)
#1=0
WHILE [#1 LT 2] DO1 #1=#1+1
; expect error 3:21 E2001
END1
; expect error 5:1 E2013
M30
