; channel table A
; Without a C the face is that of the only rotary axis: A, which is a length beside Y, about X. Arcs
; have J and K whichever plane is active: from Y10 A0 about the centre Y0 A0 to Y0 A10.
G12.1
; expect: transformation polar face A
; expect: request sync
G1 Y10 A0 F100
; expect: line Y10 A0 F100
G3 Y0 A10 J-10 K0
; expect: arc ccw yz centre 0,0 Y0 A10 F100
G3 Y-10 A0 R10
; expect: arc ccw yz centre 0,0 Y-10 A0 F100
G13.1
; expect: transformation off
; expect: request sync
G1 A90
; expect: line A90 F100
M30
; expect: end and rewind
