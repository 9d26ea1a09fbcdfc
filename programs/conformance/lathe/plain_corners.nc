(dialect fanuc A)
; channel plain corners
; Direct drawing dimension programming by the manual of Fanuc (B-64304EN-1), without commas; the
; records have radii. A is counted from +Z towards +X. The rounding of 5 mm touches the lines at
; Z-15 and X30 about (-15,30).
G99 S500 M3
; expect: spindle speed 500
; expect: spindle clockwise 500
G0 X0 Z0
; expect: rapid X0 Z0 per revolution
G1 X50 C2 F0.2
; expect: line X23 Z0 F0.2 per revolution
; expect: line X25 Z-2 F0.2 per revolution
Z-20 R5
; expect: line X25 Z-15 F0.2 per revolution
; expect: arc cw zx centre -15,30 X30 Z-20 F0.2 per revolution
X80
; expect: line X40 F0.2 per revolution
G1 Z-30 A180
; expect: line X40 Z-30 F0.2 per revolution
X90 A135
; expect: line X45 Z-35 F0.2 per revolution
M30
; expect: spindle stop 0 $-1
; expect: end and rewind
