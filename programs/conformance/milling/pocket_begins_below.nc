; A tool that stands below the level R goes up before it goes over the start point.
G0 X0 Y0 Z-3
; expect: rapid X0 Y0 Z-3
G150 P20 X8 Y1.6 Z-1 R1 Q2 J1.2 G41 D1 F100
; expect: rapid Z1
; expect: rapid X8 Y1.6
; expect: line Z-1 F100
; expect: line X8 Y1.001 F100
; expect: line X18.999 Y1.001 F100
; expect: line X18.999 Y3.001 F100
; expect: line X1.001 Y3.001 F100
; expect: line X1.001 Y1.001 F100
; expect: line X8 Y1.001 F100
; expect: rapid Z1
; expect: rapid X1.001 Y2.001
; expect: line Z-1 F100
; expect: line X18.999 Y2.001 F100
; expect: rapid Z1
; expect: rapid X8 Y1.6
M30
; expect: end and rewind
O20
G1 Y0
X20
Y4.002
X0
Y0
X8
M99
