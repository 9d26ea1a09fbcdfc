; Depths stay valid from hole to hole; G98 returns to the initial level, G99 to R.
G0 X0 Y0 Z20
; expect: rapid X0 Y0 Z20
G99 G81 X10 Y5 Z-3 R2 F100
; expect: rapid X10 Y5
; expect: rapid Z2
; expect: line Z-3 F100
; expect: rapid Z2
G98 X20
; expect: rapid X20
; expect: line Z-3 F100
; expect: rapid Z20
G82 Y8 P0.5
; expect: rapid Y8
; expect: rapid Z2
; expect: line Z-3 F100
; expect: dwell 0.5
; expect: rapid Z20
G80
G0 X0
; expect: rapid X0
G1 Z1
; expect: line Z1 F100
G85 X1 Z-1 R3
; expect: rapid Z3
; expect: rapid X1
; expect: line Z-1 F100
; expect: line Z3 F100
M30
; expect: end and rewind
