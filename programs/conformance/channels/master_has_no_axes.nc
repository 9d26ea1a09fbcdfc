; channel master
G0 X1
; expect error 2:4 E4010
M3
; expect error 4:1 E4009
S100
; expect error 6:1 E4009
T1
; expect error 8:1 E4009
#kinematics (9, 1)
; expect error 10:14 E5201
channel_wait (2);
; expect error 12:15 E6031
channel_wait (8);
; expect error 14:15 E6001
M30
