; A length that the table does not have is no length of 0. Tools 1 to 9 are in the table.
G43 H9
; expect: length H9 0 0 90
G0 X1
; expect: rapid X1
G43 H10
; expect error 6:5 E5021
M30
