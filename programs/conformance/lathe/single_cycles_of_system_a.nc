(dialect haas A)
; channel lathe
; Haas lathe operator's manual, G90, G92, G94: I and K are the taper. A block `G90 G54` without
; coordinates only chooses the cycle, as a code of its group does: nothing moves.
G98 F100. S300 M3
; expect: spindle speed 300
; expect: spindle clockwise 300
G90 G54
G0 X40. Z2.
; expect: rapid X20 Z2
G90 X36. Z-10. I-1.
; expect: rapid X17
; expect: line X18 Z-10 F100
; expect: line X20 F100
; expect: rapid Z2
G94 X30. Z-1. K-2.
; expect: rapid Z-3
; expect: line X15 Z-1 F100
; expect: line Z2 F100
; expect: rapid X20
M24
G92 X38. Z-5. I-0.5 F1.5
; expect: rapid X18.5
; expect: thread X19 Z-5 lead 1.503821662
; expect: rapid X20
; expect: rapid Z2
M30
; expect: spindle stop 0 $-1
; expect: end and rewind
