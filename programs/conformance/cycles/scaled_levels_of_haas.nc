(dialect haas)
; "Scaling does not affect canned cycle Z-axis movements such as clearance planes" (Haas mill
; operator's manual, G51).
G0 Z10
; expect: rapid Z10
G51 X0 Y0 Z0 P2.
G99 G81 X5 Y5 Z-3 R2 F100
; expect: rapid X10 Y10
; expect: rapid Z2
; expect: line Z-3 F100
; expect: rapid Z2
G80 G50
M30
; expect: end and rewind
