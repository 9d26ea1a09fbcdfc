G0 Z1
; expect: rapid Z1
G12 I1 Z-1 D1 F100
M30
; expect error 3:5 E4008
