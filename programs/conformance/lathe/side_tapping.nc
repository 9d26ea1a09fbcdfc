(dialect fanuc A)
; channel lathe
; G88 taps into the side (B-64304EN-1, 5.2).
G98 G0 X50. Z-10. C0.
; expect: rapid X25 Z-10 C0
S300 M3 G0 X60.
; expect: spindle speed 300
; expect: spindle clockwise 300
; expect: rapid X30
G88 X40. R-5. F450
; expect: rapid X25
; expect: overrides off
; expect: line X20 F450
; expect: spindle counter-clockwise 300
; expect: line X25 F450
; expect: spindle clockwise 300
; expect: overrides on
; expect: rapid X30
M30
; expect: spindle stop 0 $-1
; expect: end and rewind
