; A radius that the table does not have is none of 0.
G0 X1
; expect: rapid X1
G41 D10
; expect error 4:5 E5021
M30
