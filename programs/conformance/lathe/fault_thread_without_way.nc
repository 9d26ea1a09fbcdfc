; channel lathe
; A thread to where the tool stands.
S500 M3
; expect: spindle speed 500
; expect: spindle clockwise 500
G33 Z0 K1
; expect error 6:1 E4067
M30
