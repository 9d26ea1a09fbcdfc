; channel lathe
; X is a diameter in every coordinate, absolute and incremental; centres and radii are radii.
G0 X20 Z0
; expect: rapid X10 Z0 per revolution
G91 X4
; expect: rapid X12 per revolution
G90 U4 W-3
; expect: rapid X14 Z-3 per revolution
G3 X30 Z-4 I0 K-1 F0.2
; expect: arc ccw zx centre -4,14 X15 Z-4 F0.2 per revolution
G2 X32 Z-5 R1
; expect: arc cw zx centre -4,16 X16 Z-5 F0.2 per revolution
G90.1 G2 X34 Z-4 I16 K-4
; expect: arc cw zx centre -4,16 X17 Z-4 F0.2 per revolution
G1 G91.1 U-2 Z-3
; expect: line X16 Z-3 F0.2 per revolution
G8 X20
; expect: line X20 F0.2 per revolution
G7 X20
; expect: line X10 F0.2 per revolution
; Shifts and centres are coordinates.
G52 X8
; expect: frame 1 X4 Z0 C0
G52 X0
; expect: frame 1 X0 Z0 C0
G51 X10 Z0 P2
X12
; expect: line X7 F0.2 per revolution
G50
G92 X20
; expect: frame 1 X-3 Z0 C0
G92.1
; expect: frame 1 X0 Z0 C0
; Values of tables are radii, as they are written.
G10 L2 P2 X8
; expect: request write offset channel 1 2 X 8
G10 L20 P2 X8
; expect: request write offset channel 1 2 X 3
G10 L1 P3 X8 Z9
; expect: request write tool channel 3 3 length_x 8
; expect: request write tool channel 1 3 length 9
G43.1 X6
; expect: length H0 6 0 0
G49
; expect: length off
G53 G0 X30
; expect: rapid X15 per revolution machine
G28 U2 W0
; expect: rapid X16 Z-3 per revolution
; expect: rapid X0 Z0 per revolution machine
G28.1
G0 X11
; expect: rapid X5.5 per revolution
msg (str ($prog_pos[X]) + " " + str (#5420) + " " + str (#<_x>));
; expect: message 11 11 11
M30
; expect: end and rewind
