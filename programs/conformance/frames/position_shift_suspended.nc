; G92.2 suspends the shift of G92, G92.3 brings it back, G92.1 forgets it.
G0 X10 Y20
; expect: rapid X10 Y20
G92 X0 Y0
; expect: frame 1 X10 Y20 Z0 B0 C0
G92.2
; expect: frame 1 X0 Y0 Z0 B0 C0
X1
; expect: rapid X1
G92.3
; expect: frame 1 X10 Y20 Z0 B0 C0
X1
; expect: rapid X1
G92.1
; expect: frame 1 X0 Y0 Z0 B0 C0
G92.3
X1
; expect: rapid X1
M30
; expect: end and rewind
