; G16 (B-63944EN, 5.5): radius and angle in place of the first two axes; the manual's bolt circle.
G17 G90 G16 G0 Z10
; expect: rapid Z10
G81 X100 Y30 Z-20 R-5 F200
; expect: rapid X86.60254038 Y50
; expect: rapid Z-5
; expect: line Z-20 F200
; expect: rapid Z10
Y150
; expect: rapid X-86.60254038 Y50
; expect: rapid Z-5
; expect: line Z-20 F200
; expect: rapid Z10
G91 Y120
; expect: rapid X0 Y-100
; expect: rapid Z-5
; expect: line Z-20 F200
; expect: rapid Z10
G81 Y120 L2
; expect: rapid X86.60254038 Y50
; expect: rapid Z-5
; expect: line Z-20 F200
; expect: rapid Z10
; expect: rapid X-86.60254038 Y50
; expect: rapid Z-5
; expect: line Z-20 F200
; expect: rapid Z10
G90 G80 G0 X10 Y0
; expect: rapid X10 Y0
; A radius in G91 counts from the position, an angle is added to the last one.
G91 X5 Y90
; expect: rapid X10 Y5
X5 Y90
; expect: rapid X5 Y5
G90 G1 X20
; expect: line X-20 Y0 F200
G2 X20 Y90 R20
; expect: arc cw xy centre 0,0 X0 Y20 F200
G15 G0 X1 Y2
; expect: rapid X1 Y2
; In inches the angle stays one.
G20 G16 X1 Y90
; expect: rapid X0 Y25.4
M30
; expect: end and rewind
