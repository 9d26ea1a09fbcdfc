; channel master
#kinematics (1, 1)//first scheme
; expect: request kinematics channel 1 1
if(channel_run (1, "part.nc") == false)
{terminate (1006, "part.nc");}
; expect: request channel_run channel 1 part.nc
; expect warning W710
channel_wait (1, 600);
; expect: request channel_wait channel 1 timeout 600
if (channel_state (1) == CH_RUNNING) { channel_stop (1); }
; expect: request channel_state channel 1
; expect: request channel_stop channel 1
terminate (1020, "end " + str (1.5));
; expect: request terminate 1020 end 1.5
; expect error 13:1 U1020
M30
