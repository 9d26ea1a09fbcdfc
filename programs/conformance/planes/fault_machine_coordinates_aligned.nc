G68.2 J90
; expect: frame 1 X0 Y0 Z0 B0 C0 turned (1 0 0) (0 0 -1) (0 1 0)
G53.1
; expect: rapid B90 C90
; expect: tip H0 0 0 0
; expect: request sync
G53 G0 Z0
; expect error 7:1 E4040
M30
