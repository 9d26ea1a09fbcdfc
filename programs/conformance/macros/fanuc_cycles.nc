(dialect fanuc)
; What cycles and dwells mean in the dialect (B-63944EN, 13): P without a point in ms, K repeats, no
; P needed, behind G80 the motion from before goes on.
G0 X0 Y0 Z20 F100
; expect: rapid X0 Y0 Z20
G4 P500
; expect: dwell 0.5
G4 X1.5
; expect: dwell 1.5
G4 P1.5
; expect: dwell 1.5
G82 G99 X10 Z-1 R2 P200
; expect: rapid X10
; expect: rapid Z2
; expect: line Z-1 F100
; expect: dwell 0.2
; expect: rapid Z2
G91 G81 X5 Z-3 R0 K2
; expect: rapid Z20
; expect: rapid X15
; expect: line Z17 F100
; expect: rapid Z20
; expect: rapid X20
; expect: line Z17 F100
; expect: rapid Z20
G90 G80
X1
; expect: rapid X1
G81 X2 Z-1 R2
; expect: rapid X2
; expect: rapid Z2
; expect: line Z-1 F100
; expect: rapid Z2
G80 X1 Y0
; expect: rapid X1 Y0
G51 X0 Y0 Z0 P500
X4
; expect: rapid X2
M30
; expect: end and rewind
