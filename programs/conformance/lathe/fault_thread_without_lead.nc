; channel lathe
; A lead holds for its own block only.
S500 M3
; expect: spindle speed 500
; expect: spindle clockwise 500
G33 Z-5 F2
; expect: thread Z-5 lead 2
Z-10
; expect error 8:1 E4066
M30
