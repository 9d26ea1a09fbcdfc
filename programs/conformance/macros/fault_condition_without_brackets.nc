; A condition without brackets.
IF #1 EQ 2 GOTO 5
WHILE #1 LT 3 DO1
N5 M30
; expect error 2:4 E2001
; expect error 3:7 E2001
