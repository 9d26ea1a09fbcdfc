; No blank inside a number, one decimal point, at least one digit.
G0 X1 0
; expect error 2:7 E1003
X1.2.3
; expect error 4:5 E1002
X.
; expect error 6:2 E1002
X-
; expect error 8:3 E2001
M30
