(dialect linuxcnc)
; channel lathe
; G72 cuts along X on levels of Z, as the profile runs, and the tool ends over its end.
O200 sub
G0 X25 Z-12
G1 X15
Z-4
X0
O200 endsub
F100
G0 X30 Z2
; expect: rapid X30 Z2
G72 Q200 I5 R1
; expect: rapid Z-3
; expect: line X0 F100
; expect: line X1 Z-2 F100
; expect: rapid X30
; expect: rapid Z-8
; expect: line X15 F100
; expect: line X16 Z-7 F100
; expect: rapid X30
; expect: rapid Z-12
; expect: line X25 F100
; expect: line X15 F100
; expect: line Z-4 F100
; expect: line X0 F100
; expect: line Z2 F100
M2
; expect: end
