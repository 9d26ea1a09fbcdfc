(dialect linuxcnc)
F100 G2 X50 I24.9857
; expect error 2:6 E4032
M30
