; channel lathe
; G77, G78 and G79 begin and end where they are called; X, Z, R and the lead stay valid.
G8 G94 F100 S300 M3 G0 X20 Z2
; expect: spindle speed 300
; expect: spindle clockwise 300
; expect: rapid X20 Z2
G77 X18 Z-10
; expect: rapid X18
; expect: line Z-10 F100
; expect: line X20 F100
; expect: rapid Z2
U-4 R-1
; expect: rapid X15
; expect: line X16 Z-10 F100
; expect: line X20 F100
; expect: rapid Z2
G79 X5 Z0 R-1
; expect: rapid Z-1
; expect: line X5 Z0 F100
; expect: line Z2 F100
; expect: rapid X20
G78 X17 Z-8 F1.5
; expect: rapid X17
; expect: thread Z-8 lead 1.5
; expect: rapid X20
; expect: rapid Z2
X16
; expect: rapid X16
; expect: thread Z-8 lead 1.5
; expect: rapid X20
; expect: rapid Z2
G1 X19
; expect: line X19 F100
G78 Z-8 F1.5
; expect error 34:1 E4007
M30
