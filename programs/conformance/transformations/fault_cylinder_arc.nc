G7.1 C25
; expect: transformation cylinder 25 C
; expect: request sync
G18 G2 Z1 C10 R20 F100
M30
; expect error 4:5 E2090
