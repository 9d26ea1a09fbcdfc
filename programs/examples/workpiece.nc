%
(A POCKET WITH AN ISLAND, AND A WAVE ROUND IT, IN A BLOCK OF 80 X 60 X 20)
(ZERO IN THE MIDDLE OF THE TOP FACE; TOOL 3: END MILL 6, TOOL 4: BALL MILL 6)
(stanok simulate workpiece.nc --machine e7106mf4.toml --picture workpiece.png)
N10 G21 G90 G17 G40 G49 G80
N20 G54
#workpiece (0, 0.2, 0, 80, 60, 20, 40, 30, 20)//box, milling; zero from its lowest corner

(pocket of 36 x 28, 6 deep, in two layers; a round island of 11 stays)
N30 T3 M6
N40 S9000 M3
N50 G0 X-15 Y-11
N60 G43 H3 Z50
N70 G64 P0.01
N80 G0 Z2
num depth = 0;
num inset = 0;
for (depth = 3; depth <= 6; depth = depth + 3)
{
  N90 G0 X-15 Y-11
  N100 G1 Z=-depth F300
  for (inset = 0; inset <= 2; inset = inset + 2)
  {
    N110 G1 X=-15+inset Y=-11+inset F1200
    N120 X=15-inset
    N130 Y=11-inset
    N140 X=-15+inset
    N150 Y=-11+inset
  }
  N160 G1 X-10.5 Y0
  N170 G2 I10.5
  N180 G1 X-8.5
  N190 G2 I8.5
  N200 G0 Z2
}
N210 G0 Z50 M5

(a wave, 2 deep, in the rim)
N220 T4 M6
N230 S12000 M3
N240 G0 X-35 Y0
N250 G43 H4 Z50
N260 G0 Z2
N270 G1 Z-2 F300
num angle = 0;
for (angle = 2; angle <= 360; angle = angle + 2)
{
  G1 X=(-35 - sin (12*angle))*cos (angle) Y=(-26 - sin (12*angle))*sin (angle) F1500
}
N280 G0 Z50 M9
N290 G49 M5
N300 M30
%
