(dialect fanuc)
; G0 beside G28: the motion code is for the blocks to come. Codes of Haas without an effect here.
G103 P1
G187 P3 E0.02
G0 G90 G54 X5
; expect: rapid X5
G91 G0 G28 Z0
; expect: rapid Z0
; expect: rapid Z0 machine
G90 G154 P2
; expect: frame 11 X0 Y0 Z0 B0 C0
X6
; expect: rapid X6
GOTO 3
N2
N3
M30
; expect: end and rewind
