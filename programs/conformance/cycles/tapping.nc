; channel two spindles
; Spindle 1 has a position: it leads the axis. Spindle 2 needs a floating chuck: overrides are off
; while the tap is in. The lead is F / S, or K.
S500 G0 Z5
; expect: spindle speed 500
; expect: rapid Z5
G84 X10 Z-10 R2 F500
; expect: rapid X10
; expect: rapid Z2
; expect: spindle clockwise 500
; expect: rigid tap Z-10 lead 1
; expect: rapid Z5
G99 X20 K1.25
; expect: rapid X20
; expect: rapid Z2
; expect: rigid tap Z-10 lead 1.25
G74 S200 $2 Z-4 P0.5 K1
; expect: spindle speed 200 $2
; expect: spindle counter-clockwise 200 $2
; expect: overrides off
; expect: line Z-4 F200
; expect: dwell 0.5
; expect: spindle clockwise 200 $2
; expect: line Z2 F200
; expect: spindle counter-clockwise 200 $2
; expect: overrides on
G80
M30
; expect: spindle stop 0 $-1
; expect: end and rewind
