G81 X1 Z-1 R1 F100
; expect: rapid Z1
; expect: rapid X1
; expect: line Z-1 F100
; expect: rapid Z1
G12.1
M30
; expect error 6:1 E4301
