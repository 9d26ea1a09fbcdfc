; A pocket of 20 x 4.002 in levels of 2 from R, around its walls and on one line; the tool has the
; radius 1 and stays 0.001 farther away. At the end it stands over the start point.
G0 X8 Y1.6 Z5
; expect: rapid X8 Y1.6 Z5
G150 P20 Z-2 R1 Q2 J1.2 G41 D1 F100
; expect: rapid Z1
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
; expect: line Z-2 F100
; expect: line X8 Y1.001 F100
; expect: line X18.999 Y1.001 F100
; expect: line X18.999 Y3.001 F100
; expect: line X1.001 Y3.001 F100
; expect: line X1.001 Y1.001 F100
; expect: line X8 Y1.001 F100
; expect: rapid Z1
; expect: rapid X1.001 Y2.001
; expect: line Z-2 F100
; expect: line X18.999 Y2.001 F100
; expect: rapid Z1
; expect: rapid X8 Y1.6
G1 X9
; expect: line X9 F100
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
