; A jump that cannot be made is an error when the program is loaded.
GOTO 9999
IF [#1 EQ 1] GOTO 20
GOTO 30
DO1
N30 X1
GOTO 30
END1
N20 X1
N20 X2
GOTO 40
M30
O1
N40 X1
M99
; expect error 2:6 E3024
; expect error 3:19 E3024
; expect error 4:6 E3024
; expect error 11:6 E3024
