(dialect fanuc)
; Radius compensation begins with a line (B-63944EN, 14.4.2: alarm PS0034 otherwise).
F100 G42 D1
G2 X10 I5
; expect error 4:1 E4143
M30
