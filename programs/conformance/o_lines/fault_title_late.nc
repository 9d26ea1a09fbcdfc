G0 X1
O<Flange>
M30
; expect error 2:1 E2001
