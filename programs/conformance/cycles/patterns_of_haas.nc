(dialect haas)
; Haas mill operator's manual, G70, G71, G72: holes on a circle (I radius, J angle of the first one, L
; holes), on an arc (K angle from hole to hole) and on a line (I way from hole to hole, J its angle),
; with the cycle that is active. The centre, or the first hole of a line, is where the tool stands.
G0 X0 Y0 Z20 F100
; expect: rapid X0 Y0 Z20
G81 G99 Z-10 R2 L0
G70 I10 J90 L4
; expect: rapid X0 Y10
; expect: rapid Z2
; expect: line Z-10 F100
; expect: rapid Z2
; expect: rapid X-10 Y0
; expect: line Z-10 F100
; expect: rapid Z2
; expect: rapid X0 Y-10
; expect: line Z-10 F100
; expect: rapid Z2
; expect: rapid X10 Y0
; expect: line Z-10 F100
; expect: rapid Z2
G0 X0 Y0
; expect: rapid X0 Y0
G81 Z-10 R2 L0
G71 I10 J0 K-90 L2
; expect: rapid X10 Y0
; expect: line Z-10 F100
; expect: rapid Z2
; expect: rapid X0 Y-10
; expect: line Z-10 F100
; expect: rapid Z2
G72 I5 J90 L2
; expect: rapid X0 Y-10
; expect: line Z-10 F100
; expect: rapid Z2
; expect: rapid X0 Y-5
; expect: line Z-10 F100
; expect: rapid Z2
G80
M30
; expect: end and rewind
