G68 X0 Y0 R90
; expect: frame 1 X0 Y0 Z0 B0 C0 turned (0 -1 0) (1 0 0) (0 0 1)
#kinematics (2, 1)
M30
; expect error 3:1 E5011
