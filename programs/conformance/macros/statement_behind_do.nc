(dialect haas)
; On Haas the first statement of a loop may stand on the line of its DO.
#1=0
WHILE [#1 LT 2] DO1 #1=#1+1
G0 X#1
END1
; expect: rapid X1
; expect: rapid X2
M30
; expect: end and rewind
