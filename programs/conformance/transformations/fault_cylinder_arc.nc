G7.1 C25
; expect: transformation cylinder 25 C
; expect: request sync
G18 G2 Z1 C10 I5 K5 F100
M30
; expect error 4:15 E4030
