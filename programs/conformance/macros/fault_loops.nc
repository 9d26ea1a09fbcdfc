; Loops that do not close.
END1
WHILE [#1 EQ 1] DO1
DO2
END1
END2
IF [#1 EQ 1] X1
M30
; expect error 2:1 E2013
; expect error 3:1 E2013
; expect error 4:1 E2013
; expect error 7:14 E2001
