(dialect haas A)
; channel lathe
; Haas lathe operator's manual: G73 P Q I K D in one line (D cuts, I a radius and K away from the last
; one), G76 with the angle Q where the thread begins, in thousandths; U, W and D of G70 say nothing.
G98 F100. S300 M3
; expect: spindle speed 300
; expect: spindle clockwise 300
G0 X40. Z5.
; expect: rapid X20 Z5
G73 P10 Q20 I2. K1. D3
; expect: rapid X22 Z6
; expect: rapid X12 Z1
; expect: line Z-9 F100
; expect: rapid X21 Z5.5
; expect: rapid X11 Z0.5
; expect: line Z-9.5 F100
; expect: rapid X20 Z5
; expect: rapid X10 Z0
; expect: line Z-10 F100
; expect: rapid X20 Z5
N10 G0 X20. Z0.
N20 G1 Z-10.
G70 P10 Q20 U0.2 W0. D0.01
; expect: rapid X10 Z0
; expect: line Z-10 F100
; expect: rapid X20
; expect: rapid Z5
M24
G76 X38. Z-5. K1. D1. F1.5 Q60000
; expect: rapid X19
; expect: thread Z-5 lead 1.5 angle 60
; expect: rapid X20
; expect: rapid Z5
M30
; expect: spindle stop 0 $-1
; expect: end and rewind
