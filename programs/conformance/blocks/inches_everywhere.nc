; In G20 every length of a block is in inches, feeds per minute and leads too; angles, times, counts
; and rotary axes are not.
G20 G0 X1 B1
; expect: rapid X25.4 B1
G1 Y1 F10
; expect: line Y25.4 F254
B5 F10
; expect: line B5 F10
G2 X3 I1 F10
; expect: arc cw xy centre 50.8,25.4 X76.2 F254
G3 X1 R1
; expect: arc ccw xy centre 50.8,25.4 X25.4 F254
G90.1 G2 X3 I2 J1
; expect: arc cw xy centre 50.8,25.4 X76.2 F254
G52 X1 B1
; expect: frame 1 X25.4 Y0 Z0 B1 C0
G92 X0 B0
; expect: frame 1 X76.2 Y0 Z0 B5 C0
G92.1 G52 X0 B0
; expect: frame 1 X25.4 Y0 Z0 B1 C0
; expect: frame 1 X0 Y0 Z0 B0 C0
G10 L2 P2 X1 R30
; expect: request write offset channel 1 2 X 25.4
; expect: request write offset channel 1 2 R 30
G10 L1 P2 Z1 R1
; expect: request write tool channel 1 2 length 25.4
; expect: request write tool channel 4 2 radius 25.4
G43.1 Z1
; expect: length H0 0 0 25.4
G49
; expect: length off
G1 G64 P0.1 X1
; expect: line X25.4 F254 tolerance 2.54
G53 G0 X1 B1
; expect: rapid X25.4 B1 machine tolerance 2.54
G64
G99 G83 X0 Z-1 R0.5 Q0.75
; expect: rapid Z12.7
; expect: rapid X0
; expect: line Z-6.35 F254
; expect: rapid Z12.7
; expect: rapid Z-6.096
; expect: line Z-25.4 F254
; expect: rapid Z12.7
G80 G95 S100 M3
; expect: spindle speed 100
; expect: spindle clockwise 100
G1 Y2 F0.1
; expect: line Y50.8 F2.54 per revolution
G33 Z0 K0.1
; expect: thread Z0 lead 2.54
G68 X1 Y0 R90
; expect: frame 1 X25.4 Y-25.4 Z0 B0 C0 turned (0 -1 0) (1 0 0) (0 0 1)
G69
; expect: frame 1 X0 Y0 Z0 B0 C0
G4 P1
; expect: dwell 1
G94 F10 G5 X2 Y0 I1 J1 P-1 Q1
; expect: spline 3 X50.8 Y0 (25.4 76.2) (25.4 25.4) (50.8 0) F254
M30
; expect: spindle stop 0 $-1
; expect: end and rewind
