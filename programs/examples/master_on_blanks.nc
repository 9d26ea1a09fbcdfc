//Master program as in master.nc, for programs that announce their blanks. Should be run on 2nd channel
#include "car_body.nc"
#include "blade.nc"
#kinematics (1, 1)//the vise
if (channel_run (1, "car_body.nc") == false)
{terminate (1006, "car_body.nc");}
channel_wait (1);
#kinematics (2, 1)//the table
if (channel_run (1, "blade.nc") == false)
{terminate (1006, "blade.nc");}
channel_wait (1);
M30
