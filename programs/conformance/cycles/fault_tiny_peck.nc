; A peck so small that the hole would take days.
F100
G83 X1 Z-10 R1 Q0.00001
; expect error 3:16 E4063
M30
