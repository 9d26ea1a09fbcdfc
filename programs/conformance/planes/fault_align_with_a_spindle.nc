; channel spindle axis
; C turns as a spindle: it is no axis that could bring the plane under the tool.
G68.2 I90 J90
; expect: frame 1 X0 Y0 Z0 B0 C0 turned (0 0 1) (1 0 0) (0 1 0)
G53.1
; expect error 5:1 E4055
M30
