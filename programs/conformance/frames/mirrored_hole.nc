; R, Z and the hole's place are scaled; the peck is not.
G51 X0 Y0 Z0 P2
G51.1 X0
G0 Z5
; expect: rapid Z10
G99 G83 X3 Y1 Z-2 R1 Q3 F100
; expect: rapid X-6 Y2
; expect: rapid Z2
; expect: line Z-1 F100
; expect: rapid Z2
; expect: rapid Z-0.746
; expect: line Z-4 F100
; expect: rapid Z2
G80
M30
; expect: end and rewind
