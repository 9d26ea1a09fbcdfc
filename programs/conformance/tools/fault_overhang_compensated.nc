; A sync point, so not while radius compensation is active.
T1 M6 F100
; expect: prepare T1
; expect: change T1
G41 G1 X10
Y20
; expect: line X9 Y0 F100
; expect: line X9 Y20 F100
#tool_overhang (3)
M30
; expect error 9:1 E4140
