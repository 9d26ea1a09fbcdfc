(dialect linuxcnc)
G0 X[1 + (open]
; expect error 2:10 E1006
M2
