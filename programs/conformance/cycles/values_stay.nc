; R, Z, Q and P stay from hole to hole, until another motion; L0 only stores, and makes no hole.
G0 X0 Y0 Z10
; expect: rapid X0 Y0 Z10
G99 G82 Z-2 R1 P0.5 F100 L0
X5
; expect: rapid X5
; expect: rapid Z1
; expect: line Z-2 F100
; expect: dwell 0.5
; expect: rapid Z1
Y5 Z-1
; expect: rapid Y5
; expect: line Z-1 F100
; expect: dwell 0.5
; expect: rapid Z1
G98 Y10 P0
; expect: rapid Y10
; expect: line Z-1 F100
; expect: dwell 0
; expect: rapid Z10
G0 X0
; expect: rapid X0
G81 X1
M30
; expect error 23:1 E4061
