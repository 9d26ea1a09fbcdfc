(dialect fanuc)
; H alone under G43 is another offset (Fanuc B-63944EN, 14.1: H is modal).
G43 H1
; expect: length H1 0 0 10
H2
; expect: length H2 0 0 20
G0 Z5
; expect: rapid Z5
G49
; expect: length off
M30
; expect: end and rewind
