; channel lathe
; K is the lead along the path, F the lead along the axis that travels farther; a rigid tap comes back.
S500 M3 G8 G94
; expect: spindle speed 500
; expect: spindle clockwise 500
G0 X12 Z5
; expect: rapid X12 Z5
G33 Z-20 K1.5
; expect: thread Z-20 lead 1.5
G0 Z5
; expect: rapid Z5
G32 X9 Z1 F2 Q90
; expect: thread X9 Z1 lead 2.5 angle 90
X12 Z5 K2
; expect: thread X12 Z5 lead 2
G33.1 Z0 K1 I2
; expect: rigid tap Z0 lead 1 return 2
G0 W1
; expect: rapid Z6
G1 Z0
; expect error 20:1 E4020
M30
