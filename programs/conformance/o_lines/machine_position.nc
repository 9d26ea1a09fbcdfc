; Where the axes stand in machine coordinates (LinuxCNC, "G-Code Overview", predefined named
; parameters; expected as tests/interp/rotation/abs-pts there).
G92 X3 Y7
; expect: frame 1 X-3 Y-7 Z0 B0 C0
G68 R45
; expect: frame 1 X2.828427125 Y-7.071067812 Z0 B0 C0 turned (0.7071067812 -0.7071067812 0) (0.7071067812 0.7071067812 0) (0 0 1)
G53 G0 X1 Y2 Z3
; expect: rapid X1 Y2 Z3 machine
(PRINT,#<_abs_x> #<_abs_y> #<_abs_z>)
; expect: log 1.000000 2.000000 3.000000
G43.1 Z5
; expect: length H0 0 0 5
G20
(PRINT,%.4f#<_abs_z>)
; expect: log 0.1181
M30
; expect: end and rewind
