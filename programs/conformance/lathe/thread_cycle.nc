; channel lathe
; G76 with K: passes of J, the rest, a spring pass; the run-out is as long as the depth is deep.
G8 G94 S300 M3 G0 X20 Z5
; expect: spindle speed 300
; expect: spindle clockwise 300
; expect: rapid X20 Z5
G76 Z-10 P1.5 I-1 J0.3 K0.5 H1 E1 L2
; expect: rapid X18.7
; expect: thread Z-9.4 lead 1.5
; expect: thread X19 Z-10 lead 1.677050983
; expect: rapid X20
; expect: rapid Z5
; expect: rapid X18.5
; expect: thread Z-9 lead 1.5
; expect: thread X19 Z-10 lead 1.677050983
; expect: rapid X20
; expect: rapid Z5
; expect: rapid X18.5
; expect: thread Z-9 lead 1.5
; expect: thread X19 Z-10 lead 1.677050983
; expect: rapid X20
; expect: rapid Z5
M30
; expect: spindle stop 0 $-1
; expect: end and rewind
