; What is off at the start may be switched off again; G60 and G61 are the same.
G0 X1 G13.1 G15 G40 G49 G50
; expect: rapid X1
G50.1 G69 G97
G60 G1 X2 F100
; expect: line X2 F100 exact path
G61 X3
; expect: line X3 F100 exact path
M29
M48
; expect: overrides on
M1
; expect: optional stop
; expect: request sync
X4
; expect: line X4 F100 exact path
M60
; expect: pallet stop
; expect: request sync
X5
; expect: line X5 F100 exact path
M2
; expect: end
