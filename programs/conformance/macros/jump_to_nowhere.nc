(dialect fanuc)
; A jump to a block that is not there is an alarm when it is made (Fanuc, alarm 128), not before.
; expect warning E3024
; expect warning E3024
; expect error 10:5 E3024
#1=1
IF[#1EQ2]GOTO77
X#1
; expect: rapid X1
GOTO78
M30
