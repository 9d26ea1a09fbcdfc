(dialect fanuc A)
; channel lathe
; Cycles in one block (Haas lathe operator's manual, G75, G76): I K D in place of two blocks.
G98 G0 X40. Z2. F100. S300 M3
; expect: spindle speed 300
; expect: spindle clockwise 300
; expect: rapid X20 Z2
G75 X36. I1.
; expect: line X19 F100
; expect: line X18 F100
; expect: rapid X20
G76 X38. Z-5. K1. D1. F1.5
; expect: rapid X19
; expect: thread Z-5 lead 1.5
; expect: rapid X20
; expect: rapid Z2
M30
; expect: spindle stop 0 $-1
; expect: end and rewind
