; Lines alone turn the table that carries the offset.
G54.2 P1
G2 X10 I5 C20 F600
; expect error 3:1 E4301
M30
