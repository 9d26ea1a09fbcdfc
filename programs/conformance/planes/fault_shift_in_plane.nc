G68.2 J90
; expect: frame 1 X0 Y0 Z0 B0 C0 turned (1 0 0) (0 0 -1) (0 1 0)
G92 X0
; expect error 3:1 E4301
M30
