(dialect haas A)
; channel lathe
; Haas lathe operator's manual: G81, G82, G85, G86 and G89 drill and bore along Z, G184 taps to the
; left, R is a position.
G0 X0. Z10. F0.2 S500 M3
; expect: spindle speed 500
; expect: spindle clockwise 500
; expect: rapid X0 Z10 per revolution
G81 Z-5. R2.
; expect: rapid Z2 per revolution
; expect: line Z-5 F0.2 per revolution
; expect: rapid Z10 per revolution
G82 Z-6. R2. P.5
; expect: rapid Z2 per revolution
; expect: line Z-6 F0.2 per revolution
; expect: dwell 0.5
; expect: rapid Z10 per revolution
G85 Z-7. R2.
; expect: rapid Z2 per revolution
; expect: line Z-7 F0.2 per revolution
; expect: line Z2 F0.2 per revolution
; expect: rapid Z10 per revolution
G89 Z-8. R2. P.25
; expect: rapid Z2 per revolution
; expect: line Z-8 F0.2 per revolution
; expect: dwell 0.25
; expect: line Z2 F0.2 per revolution
; expect: rapid Z10 per revolution
G80
G184 Z-9. R2. F1.5
; expect: rapid Z2 per revolution
; expect: spindle counter-clockwise 500
; expect: overrides off
; expect: line Z-9 F1.5 per revolution
; expect: spindle clockwise 500
; expect: line Z2 F1.5 per revolution
; expect: spindle counter-clockwise 500
; expect: overrides on
; expect: rapid Z10 per revolution
G80
M30
; expect: spindle stop 0 $-1
; expect: end and rewind
