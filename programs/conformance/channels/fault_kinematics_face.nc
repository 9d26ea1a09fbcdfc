G12.1
; expect: transformation polar face C
; expect: request sync
#kinematics (2, 1)
M30
; expect error 4:1 E5011
