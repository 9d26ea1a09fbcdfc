(dialect linuxcnc)
G17 G41.1 D5 L3 G1 X10 F100
; expect error 2:14 E4003
M2
