; On the face C is a length: in inches, at a feed in mm/min, in arcs with X.
G12.1
; expect: transformation polar face C
; expect: request sync
G1 C90 F100
; expect: line C90 F100
G2 X10 C100 J10
; expect: arc cw xy centre 0,100 X10 C100 F100
G20 G1 C1
; expect: line C25.4 F100
G13.1
; expect: transformation off
; expect: request sync
G13.1
; A rotary axis in deg again, on its shortest way.
G1 C1 F7
; expect: line C1 F7
M30
; expect: end and rewind
