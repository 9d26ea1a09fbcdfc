; Distance from zero and angle: the bolt circle of LinuxCNC's own example polar.ngc, in mm.
G0 X2.5 Y0
; expect: rapid X2.5 Y0
G81 R1 Z-5 F60 ^120
; expect: rapid Z1
; expect: rapid X-1.25 Y2.165063509
; expect: line Z-5 F60
; expect: rapid Z1
@5 ^240
; expect: rapid X-2.5 Y-4.330127019
; expect: line Z-5 F60
; expect: rapid Z1
G80 G0 @10 ^[180/2]
; expect: rapid X0 Y10
; What is left out is that of the position; in G91 both are added, from hole to hole too.
^0
; expect: rapid X10 Y0
G91 G1 @-5 ^90 F100
; expect: line X0 Y5 F100
G81 ^90 R0 Z-3 L2
; expect: rapid X-5 Y0
; expect: line Z-2 F100
; expect: rapid Z1
; expect: rapid X0 Y-5
; expect: line Z-2 F100
; expect: rapid Z1
M30
; expect: end and rewind
