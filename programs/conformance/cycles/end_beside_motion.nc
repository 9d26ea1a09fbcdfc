; G80 beside G0 to G3, in either order: the motion ends the cycle, G80 adds nothing.
G0 Z20 F50
; expect: rapid Z20
G81 X10 Z-5 R2
; expect: rapid X10
; expect: rapid Z2
; expect: line Z-5 F50
; expect: rapid Z20
G80 G0 X30
; expect: rapid X30
X31
; expect: rapid X31
G1 G80 X40
; expect: line X40 F50
X41
; expect: line X41 F50
M30
; expect: end and rewind
