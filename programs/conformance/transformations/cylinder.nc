G7.1 C25
; expect: transformation cylinder 25 C
; expect: request sync
G1 C90 Z-5 F100
; expect: line Z-5 C90 F100
G7.1 C0
; expect: transformation off
; expect: request sync
G20 G7.1 C1
; expect: transformation cylinder 25.4 C
; expect: request sync
M30
; expect: transformation off
; expect: end and rewind
