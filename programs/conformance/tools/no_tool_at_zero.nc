; Without that dialect H0 and D0 are no length and no radius.
T3 M6 G43 H0
; expect: prepare T3
; expect: change T3
; expect: length H0 0 0 0
F100 G41 D0 G1 X5
; expect: line X5 F100
M30
; expect: end and rewind
