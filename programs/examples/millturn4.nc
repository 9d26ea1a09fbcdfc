%
(FOUR CHANNELS AT ONE PART: THIS PROGRAM OF CHANNEL 1 STARTS THE OTHERS)
(CHANNEL 2 TURNS FROM BELOW, CHANNEL 3 MILLS, CHANNEL 4 HAS THE SUB-SPINDLE)
#include "millturn4_lower.nc"
#include "millturn4_mill.nc"
#include "millturn4_sub.nc"
channel_run (2, "millturn4_lower.nc");
channel_run (3, "millturn4_mill.nc");
channel_run (4, "millturn4_sub.nc");

N10 G21 G90 G18 G7 G40 G54
N20 T0101
N30 G97 S1200 M3
N40 G95 G0 X62 Z2
num depth = 0;
for (depth = 58; depth >= 50; depth = depth - 2)
{
  G0 X=depth
  G1 Z-40 F0.3
  G1 X=depth+2
  G0 Z2
}
N50 G0 X160 Z100
N60 M5

(two flats on the face by X and C)
N70 M902
N80 G94 G8 G0 X40 Z-3 C0
N90 G12.1
N100 G1 X20 C-30 F1500
N110 X20 C30
N120 G0 X-20 C40
N130 G1 X-20 C-30
N140 G0 X40 C-40
N150 G13.1
N160 M903

(the slide of the sub-spindle: channel 4 has let it go at mark 5)
N170 G0 X160 Z200
mark_wait (5, 4);
#kinematics (2, 1)
N180 G94 G0 Z4=400
N190 G1 Z4=260 F2000
N200 G4 P0.3
N210 G0 Z4=900
#kinematics (1, 1)
mark_wait (6, 4);

channel_wait (2);
channel_wait (3);
channel_wait (4);
N220 M30
%
