; M70 keeps the state for M72, M71 drops what was kept, M73 gives the state back when its subprogram returns.
G21 G90 F100
M70
G91 F50
G1 X1
; expect: line X1 F50
M72
G1 X5
; expect: line X5 F100
M98 P7
; expect: line X7 F20
G1 X9
; expect: line X9 F100
M70
M71
M72
M30
; expect error 16:1 E4014
O7
M73
G91 F20
G1 X2
M99
