; channel lathe
; G76 without K: X is the root, depths grow with the square root of the pass, and a last cut is left.
G8 G94 S300 M3 G0 X20 Z5
; expect: spindle speed 300
; expect: spindle clockwise 300
; expect: rapid X20 Z5
G76 P010000 Q0.05 R0.1
G76 X18 Z-10 P1 Q0.5 F2
; expect: rapid X18.5
; expect: thread Z-10 lead 2
; expect: rapid X20
; expect: rapid Z5
; expect: rapid X18.29289322
; expect: thread Z-10 lead 2
; expect: rapid X20
; expect: rapid Z5
; expect: rapid X18.1339746
; expect: thread Z-10 lead 2
; expect: rapid X20
; expect: rapid Z5
; expect: rapid X18.1
; expect: thread Z-10 lead 2
; expect: rapid X20
; expect: rapid Z5
; expect: rapid X18
; expect: thread Z-10 lead 2
; expect: rapid X20
; expect: rapid Z5
M30
; expect: spindle stop 0 $-1
; expect: end and rewind
