(dialect fanuc)
G0 X1 (A (B)
; expect error 2:7 E1006
