; channel lathe
; G74 and G75 (B-64304EN-1, 4.2.5 and 4.2.6).
G8 G94 F100 G0 X20 Z2
; expect: rapid X20 Z2
G74 R0.5
G74 X18 Z-6 P2 Q4 R0.2
; expect: line Z-2 F100
; expect: rapid Z-1.5
; expect: line Z-6 F100
; expect: rapid Z2
; expect: rapid X18
; expect: line Z-2 F100
; expect: rapid Z-1.5
; expect: line Z-6 F100
; expect: rapid X18.2
; expect: rapid Z2
; expect: rapid X20
G75 X16 Z2 P3
; expect: line X17 F100
; expect: rapid X17.5
; expect: line X16 F100
; expect: rapid X20
G75 X18 Z-2 Q3
; expect: line X18 F100
; expect: rapid X20
; expect: rapid Z-1
; expect: line X18 F100
; expect: rapid X20
; expect: rapid Z-2
; expect: line X18 F100
; expect: rapid X20
; expect: rapid Z2
X21
; expect: rapid X21
M30
; expect: end and rewind
