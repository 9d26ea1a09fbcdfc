(dialect linuxcnc)
; NISTIR 6556, 3.5.16: R and Z stay valid as numbers, which G90 or G91 of each block gives its
; meaning. Levels as rs274 of LinuxCNC 2.9 makes them.
G0 X0 Y0 Z10 F100
; expect: rapid X0 Y0 Z10
G99 G81 X1 Z-5 R2
; expect: rapid X1
; expect: rapid Z2
; expect: line Z-5 F100
; expect: rapid Z2
; From the initial level: R at 10 + 2, Z at 12 - 5.
G91 X1
; expect: rapid Z12
; expect: rapid X2
; expect: line Z7 F100
; expect: rapid Z12
G90 X5
; expect: rapid X5
; expect: rapid Z2
; expect: line Z-5 F100
; expect: rapid Z2
G91 X1 R-6
; expect: rapid Z4
; expect: rapid X6
; expect: line Z-1 F100
; expect: rapid Z4
X1 Z-3
; expect: rapid X7
; expect: line Z1 F100
; expect: rapid Z4
G98 X1
; expect: rapid X8
; expect: line Z1 F100
; expect: rapid Z10
; R-6 is below Z-3.
G90 X20
; expect error 36:1 E4062
M2
