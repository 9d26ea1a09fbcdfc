//Master channel part program. Should be run on 2nd channel
#include "0003_MB_3D.nc"
#include "Impeller_surface.nc"
#kinematics (1, 1)//load 1st kinematic scheme on channel 1
//execute part program "0003_MB_3D.nc" on channel 1
if(channel_run (1, "0003_MB_3D.nc") == false)
{terminate (1006, "0003_MB_3D.nc");}//error handling
channel_wait (1); //wait for the end of executing part program at channel 1
#kinematics (2, 1)//load 2nd kinematic scheme on channel 1
//execute part program "Impeller_surface.nc" on channel 1
if(channel_run (1, "Impeller_surface.nc") == false)
{terminate (1006, "Impeller_surface.nc");}//error handling
channel_wait (1); //wait for the end of executing part program on channel 1
M30
