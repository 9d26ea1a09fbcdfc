%
(EIGHT HOLES ON A CIRCLE OF 50 MM: HIGH-LEVEL LANGUAGE AND A DRILLING CYCLE)
(ZERO IN THE MIDDLE OF THE TOP FACE, TOOL 3: DRILL OF 5 MM)
num holes = 8;
num radius = 25;

N10 G21 G90 G17 G40 G49 G80
N20 T3 M6
N30 S3000 M3
N40 G54
N50 G0 X=radius Y0
N60 G43 H3 Z50
N70 G64 P0.01
N80 M8

//The cycle stays active: every pair of X and Y drills one hole, chips are broken every 4 mm
num angle = 0;
N90 G99 G83 X=radius Y0 Z-15 R2 Q4 F180
for (num hole = 1; hole < holes; hole = hole + 1)
{
  angle = 360 * hole / holes;
  X=radius*cos (angle) Y=radius*sin (angle)
}
N100 G80
N110 G0 Z50 M9
N120 G49 M5
N130 M30
%
