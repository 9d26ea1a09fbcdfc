(dialect fanuc)
; Fanuc and Haas: the levels R and Z stay where they are when G91 makes a row of holes.
G0 X0 Y0 Z10 F100
; expect: rapid X0 Y0 Z10
G99 G81 X1 Z-5 R2
; expect: rapid X1
; expect: rapid Z2
; expect: line Z-5 F100
; expect: rapid Z2
G91 X1 K2
; expect: rapid X2
; expect: line Z-5 F100
; expect: rapid Z2
; expect: rapid X3
; expect: line Z-5 F100
; expect: rapid Z2
M2
; expect: end
