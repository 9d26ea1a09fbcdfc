; channel lathe
; `G90` confirms what is active: in code system A this is a cut, here it would be a rapid.
G0 X50 Z2
; expect: rapid X25 Z2 per revolution
G90 X48 Z-30 F0.2
; expect error 5:1 E4016
M30
