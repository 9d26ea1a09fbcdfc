(dialect linuxcnc)
; channel lathe
; The drilling cycles of mills go along Z, and G98 and G99 are their levels of return.
G0 X0 Z5
; expect: rapid X0 Z5
G98 G81 Z-5 R2 F100
; expect: rapid Z2
; expect: line Z-5 F100
; expect: rapid Z5
G99 G82 Z-6 R2 P0.5
; expect: rapid Z2
; expect: line Z-6 F100
; expect: dwell 0.5
; expect: rapid Z2
G80
M2
; expect: end
