(dialect linuxcnc)
; channel lathe
; A profile with a pocket from X20 Z-20 to X20 Z-35: G71 cuts all of it, G71.1 leaves the pocket out,
; G71.2 cuts it alone.
O100 sub
G0 X10 Z0
G1 Z-10
X20 Z-20
X15 Z-25
Z-30
X25 Z-40
O100 endsub
F100
G0 X30 Z2
; expect: rapid X30 Z2
G71 Q100 I5
; expect: rapid X25
; expect: line Z-40 F100
; expect: line X25.5 Z-39.5 F100
; expect: rapid Z2
; expect: rapid X20
; expect: line Z-35 F100
; expect: line X20.5 Z-34.5 F100
; expect: rapid Z2
; expect: rapid X15
; expect: line Z-15 F100
; expect: line X15.5 Z-14.5 F100
; expect: rapid Z2
; expect: rapid X30
; expect: rapid Z-25
; expect: rapid X20
; expect: line X15 F100
; expect: line Z-30 F100
; expect: line X15.5 Z-29.5 F100
; expect: rapid X30
; expect: rapid Z2
; expect: rapid X10
; expect: line Z0 F100
; expect: line Z-10 F100
; expect: line X20 Z-20 F100
; expect: line X15 Z-25 F100
; expect: line Z-30 F100
; expect: line X25 Z-40 F100
; expect: line X30 F100
G0 X30 Z2
; expect: rapid X30 Z2
G71.1 Q100 I5
; expect: rapid X25
; expect: line Z-40 F100
; expect: line X25.5 Z-39.5 F100
; expect: rapid Z2
; expect: rapid X20
; expect: line Z-35 F100
; expect: line X20.5 Z-34.5 F100
; expect: rapid Z2
; expect: rapid X15
; expect: line Z-15 F100
; expect: line X15.5 Z-14.5 F100
; expect: rapid Z2
; expect: rapid X10
; expect: line Z0 F100
; expect: line Z-10 F100
; expect: line X20 Z-20 F100
; expect: line Z-35 F100
; expect: line X25 Z-40 F100
; expect: line X30 F100
G0 X30 Z2
; expect: rapid X30 Z2
G71.2 Q100 I5
; expect: rapid Z-25
; expect: rapid X20
; expect: line X15 F100
; expect: line Z-30 F100
; expect: line X15.5 Z-29.5 F100
; expect: rapid X30
; expect: rapid Z2
; expect: rapid X10
; expect: line Z0 F100
; expect: line Z-10 F100
; expect: line X20 Z-20 F100
; expect: line X15 Z-25 F100
; expect: line Z-30 F100
; expect: line X25 Z-40 F100
; expect: line X30 F100
M2
; expect: end
