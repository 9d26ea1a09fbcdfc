; The length saved in the plane leads the tip; behind it that would be another mode.
G68.2 I90 J90
; expect: frame 1 X0 Y0 Z0 B0 C0 turned (0 0 1) (1 0 0) (0 1 0)
G53.1
; expect: rapid B90 C0
; expect: tip H0 0 0 0
; expect: request sync
M70
G69
; expect: frame 1 X0 Y0 Z0 B0 C0
; expect: length off
; expect: request sync
M72
; expect error 13:1 E4014
M30
