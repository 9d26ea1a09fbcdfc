G0 Z60
; expect: rapid Z60
G37 Z0
M30
; expect error 3:1 E4325
