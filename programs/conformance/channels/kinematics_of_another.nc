; The modes of this channel do not matter to the scheme of another.
G68 X0 Y0 R90
; expect: frame 1 X0 Y0 Z0 B0 C0 turned (0 -1 0) (1 0 0) (0 0 1)
#kinematics (0, 2)
; expect: request kinematics channel 2
M30
; expect: end and rewind
