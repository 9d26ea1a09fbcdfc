; G83 retracts to R after every peck, G73 only by 0.254 mm.
G0 Z10
; expect: rapid Z10
G83 G99 X5 Z-5 R1 Q2.5 F60
; expect: rapid X5
; expect: rapid Z1
; expect: line Z-1.5 F60
; expect: rapid Z1
; expect: rapid Z-1.246
; expect: line Z-4 F60
; expect: rapid Z1
; expect: rapid Z-3.746
; expect: line Z-5 F60
; expect: rapid Z1
G73 X6 Z-3 Q3
; expect: rapid X6
; expect: line Z-2 F60
; expect: rapid Z-1.746
; expect: line Z-3 F60
; expect: rapid Z1
M30
; expect: end and rewind
