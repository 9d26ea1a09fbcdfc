; G68.2 puts the system anywhere into the workpiece system; the axes stand.
G68.2 X10 Y20 Z30 I0 J90 K0
; expect: frame 1 X10 Y20 Z30 B0 C0 turned (1 0 0) (0 0 -1) (0 1 0)
; Base X0 Y0 Z0 is X-10 Y-30 Z20 of the plane.
G91 G0 X0 Y0 Z0
; expect: rapid X-10 Y-30 Z20
; G68 turns within the plane, G52 shifts along its axes.
G90 G68 X0 Y0 R90
; expect: frame 1 X10 Y20 Z30 B0 C0 turned (0 -1 0) (0 0 -1) (1 0 0)
G52 Y5
; expect: frame 1 X10 Y20 Z35 B0 C0 turned (0 -1 0) (0 0 -1) (1 0 0)
; G69 ends all three.
G69
; expect: frame 1 X0 Y0 Z0 B0 C0
G91 G0 X0 Y0 Z0
; expect: rapid X0 Y0 Z0
; A plane lies in the work offset that is active, and goes with it to another one.
G90 G68.2 I90 J90
; expect: frame 1 X0 Y0 Z0 B0 C0 turned (0 0 1) (1 0 0) (0 1 0)
G55
; expect: frame 2 X100 Y200 Z300 B0 C0 turned (0 0 1) (1 0 0) (0 1 0)
; Mirror maps the coordinates of the plane, and a cycle drills along its normal.
G0 X0 Y0 Z10
; expect: rapid X0 Y0 Z10
G51.1 X0
G81 X5 Y0 Z-3 R2 F100
; expect: rapid X-5 Y0
; expect: rapid Z2
; expect: line Z-3 F100
; expect: rapid Z10
G80 G50.1
G41.1 D2 G1 X20 Y0 Z0
; expect: line X20 Y1 Z0 F100
G40 G69
; expect: frame 2 X100 Y200 Z300 B0 C0
M30
; expect: end and rewind
