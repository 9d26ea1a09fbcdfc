%
(TURN STEPS AND A CONE, MILL A HEXAGON ON THE FACE AND A WAVE ROUND THE SIDE)
(ZERO IN THE CENTRE OF THE FRONT FACE, BAR OF 60 MM; TOOL 1: INSERT, TOOL 3: AXIAL END MILL 10, TOOL 4: RADIAL BALL MILL 6)
(stanok simulate turned_part.nc --machine lathe.toml --picture turned_part.png)
N10 G21 G90 G18 G7 G40 G54
#workpiece (1, 0.2, 1, 60, 0, 90, 0, 0, 90)//bar, turning; zero on its axis, 90 from its end

(steps: 44 down to Z-20, 52 down to Z-50, and a cone to the bar)
N20 T0101
N30 G97 S900 M3
num dia = 0;
N40 G95 G0 X64 Z2
for (dia = 57; dia >= 52; dia = dia - 2.5)
{
  G0 X=dia
  G1 Z-50 F0.3
  X60 Z=-50-(60-dia)
  G0 X64
  Z2
}
for (dia = 48; dia >= 44; dia = dia - 4)
{
  G0 X=dia
  G1 Z-20 F0.3
  X54
  G0 X64
  Z2
}
N50 G0 X200 Z100 M5

(hexagon, 36 mm across flats and 8 deep: the spindle becomes C)
N60 T0301
N70 M902 H1=1
N80 $2 S4000 M3
N90 G94 G8 G0 X40 Z-8 C0
N100 G12.1
num side = 0;
num across = 46;//of the centre of the mill
num corner = across / sqrt (3);
N110 G64 P0.01 G1 X=corner C0 F1200
for (side = 1; side <= 6; side++)
{
  G1 X=corner*cos (60*side) C=corner*sin (60*side)
}
N120 G0 X40 C0
N130 G13.1
N140 G0 Z100

(a wave round the step of 52, 1.5 deep)
N150 T0401
N160 G0 X40 Z-35 C0
N170 G7.1 C26
N180 G1 X24.5 F600
num angle = 0;
for (angle = 5; angle <= 360; angle = angle + 5)
{
  G1 C=angle Z=-35+5*sin (3*angle)
}
N190 G1 X40
N200 G13.1
N210 $2 M5
N220 M903
N230 G0 X100 Z100
N240 M30
%
