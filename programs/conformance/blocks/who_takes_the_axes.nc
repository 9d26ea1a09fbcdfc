; A code without a motion of its own takes the axis words from a motion that is only modally active.
G1 X1 F100
; expect: line X1 F100
G52 X5
; expect: frame 1 X5 Y0 Z0 B0 C0
G92 Y7
; expect: frame 1 X5 Y-7 Z0 B0 C0
X2 Y8
; expect: line X2 Y8 F100
G52 X0 Y0
; expect: frame 1 X0 Y-7 Z0 B0 C0
G0 X1 G92.1
; expect: frame 1 X0 Y0 Z0 B0 C0
; expect: rapid X1
M30
; expect: end and rewind
