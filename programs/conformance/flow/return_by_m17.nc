; M17 returns as M99 does.
M98 P7
; expect: rapid X1
X2
; expect: rapid X2
M30
; expect: end and rewind
O7
G0 X1
M17
X9
