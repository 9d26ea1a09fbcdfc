(dialect haas A)
; channel lathe
; Haas lathe operator's manual, G32 and G92: Q is the angle where the thread begins, without a point.
G98 G0 X40. Z2. S300 M3
; expect: spindle speed 300
; expect: spindle clockwise 300
; expect: rapid X20 Z2
M24
G32 Z-10. F2. Q120000
; expect: thread Z-10 lead 2 angle 120
G0 Z2.
; expect: rapid Z2
G92 X38. Z-5. F1.5 Q240000
; expect: rapid X19
; expect: thread Z-5 lead 1.5 angle 240
; expect: rapid X20
; expect: rapid Z2
M30
; expect: spindle stop 0 $-1
; expect: end and rewind
