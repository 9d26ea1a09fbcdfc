(dialect fanuc)
; D is modal: G41 without D takes the last one (B-63944EN, 14.5); WH is WHILE in short.
T1 M6
; expect: prepare T1
; expect: change T1
G0 X0 Y0 F100
; expect: rapid X0 Y0
G43 H1 D2 Z50.
; expect: length H1 0 0 10
; expect: rapid Z50
#1=2
WH[#1GT0]DO1
Z#1
#1=#1-1
END1
; expect: rapid Z2
; expect: rapid Z1
G41 G1 X10 Y0
; expect: line X10 Y1 F100
X20
; expect: line X20 Y1 F100
G40 Y-5
; expect: line X20 Y-5 F100
M30
; expect: end and rewind
