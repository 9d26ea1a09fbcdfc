; M72 leaves plane and alignment what they are: the tip is led on.
G43 H2
; expect: length H2 0 0 20
M70
G68.2 I90 J90
; expect: frame 1 X0 Y0 Z0 B0 C0 turned (0 0 1) (1 0 0) (0 1 0)
G53.1
; expect: rapid B90 C0
; expect: tip H2 0 0 20
; expect: request sync
G91
M72
G0 X1 Y2 Z3
; expect: rapid X1 Y2 Z3
G0 X1
; expect: rapid X1
G69
; expect: frame 1 X0 Y0 Z0 B0 C0
; expect: length H2 0 0 20
; expect: request sync
M30
; expect: end and rewind
