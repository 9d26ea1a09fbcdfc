G0 X0.001
; expect: rapid X0.001
G27 Y0 X0.001
; expect error 3:1 E4043
M30
