; Roll, pitch and yaw: turns about axes of the workpiece system, in the order of Q.
G68.2 P1 I90
; expect: frame 1 X0 Y0 Z0 B0 C0 turned (1 0 0) (0 0 -1) (0 1 0)
G68.2 P1 Q123 I90 K90
; expect: frame 1 X0 Y0 Z0 B0 C0 turned (0 0 1) (1 0 0) (0 1 0)
G68.2 P1 Q321 I90 K90
; expect: frame 1 X0 Y0 Z0 B0 C0 turned (0 -1 0) (0 0 -1) (1 0 0)
; Three points: X from the first to the second, the third on the side of +Y; R turns about the normal.
G68.2 P2 Q1 X10 Y0 Z0
G68.2 P2 Q2 X10 Y5 Z0
G68.2 P2 Q3 X10 Y2 Z7
; expect: frame 1 X10 Y0 Z0 B0 C0 turned (0 0 1) (1 0 0) (0 1 0)
G68.2 P2 Q1 X10 Y0 Z0
G68.2 P2 Q2 X10 Y5 Z0
G68.2 P2 Q3 X10 Y2 Z7 R90
; expect: frame 1 X10 Y0 Z0 B0 C0 turned (0 0 1) (0 -1 0) (1 0 0)
; Two vectors: X, then Z.
G68.2 P3 Q1 X1 Y2 Z3 I0 J1 K0
G68.2 P3 Q2 I1
; expect: frame 1 X1 Y2 Z3 B0 C0 turned (0 0 1) (1 0 0) (0 1 0)
; Projected angles: X turned about Y by I, and Y turned about X by J.
G68.2 P4 I90
; expect: frame 1 X0 Y0 Z0 B0 C0 turned (0 0 1) (0 1 0) (-1 0 0)
G68.2 P4 J90
; expect: frame 1 X0 Y0 Z0 B0 C0 turned (1 0 0) (0 0 -1) (0 1 0)
; On top of the plane that is in force.
G68.2 X10 J90
; expect: frame 1 X10 Y0 Z0 B0 C0 turned (1 0 0) (0 0 -1) (0 1 0)
G68.4 Z5 J90
; expect: frame 1 X10 Y-5 Z0 B0 C0 turned (1 0 0) (0 -1 0) (0 0 -1)
G69
; expect: frame 1 X0 Y0 Z0 B0 C0
; Square to the tool, which B90 lays along X.
G0 B90
; expect: rapid B90
G68.3 X1 Y2 Z3
; expect: frame 1 X1 Y2 Z3 B0 C0 turned (0 0 1) (0 1 0) (-1 0 0)
G68.3 R90
; expect: frame 1 X0 Y0 Z0 B0 C0 turned (0 0 1) (1 0 0) (0 1 0)
M30
; expect: end and rewind
