%
(TRUNNION MILL: A BLOCK OF 80 X 80 MM GETS FOUR CHAMFERS OF 30 DEG AND A LEANING GROOVE ROUND ITS TOP)
(ZERO IN THE MIDDLE OF THE TOP FACE; A ROCKS THE CRADLE, C TURNS THE PLATE)
num sides = 4;
num tilt = -30;

N10 G21 G90 G17 G40 G49 G80
N20 T2 M6
N30 S9000 M3
N40 G54
N50 G64 P0.01

(Tilted faces: with A at the tilt the tool stands square on a plane that falls by 30 deg. Turning the program with C brings)
(every side under the tool. With TCP, X, Y and Z are those of the workpiece and read like the drawing)
for (num side = 0; side < sides; side = side + 1)
{
  N100 G0 A=tilt C=90*side
  N110 G43.4 H2
  N120 G68 X0 Y0 R=-90*side
  N130 G0 X-50 Y-33 Z50
  N140 Z5
  for (num pass = 1; pass <= 3; pass = pass + 1)
  {
    (One step down the slope for every pass: 3 mm outwards, 3 * tan 30 deg down)
    N150 G1 Y=-31-3*pass Z=-1.732*pass F800
    N160 X50 F1800
    N170 Z=5-1.732*pass
    N180 G0 X-50
  }
  N190 G0 Z50
  N200 G69
  N210 G49
}

(Swept contour: the tip goes once round the top while the cradle rocks between 15 and 35 deg and the plate turns with it)
N300 G0 A0 C0
N310 T3 M6
N320 S16000 M3
N330 G0 A-15 C0
N340 G43.4 H3
N350 G0 X0 Y-30 Z50 M8
N360 G0 Z3
N370 G1 Z-1 F400
N380 G2 X-30 Y0 I0 J30 A-35 C90 F1500
N390 X0 Y30 I30 J0 A-15 C180
N400 X30 Y0 I0 J-30 A-35 C270
N410 X0 Y-30 I-30 J0 A-15 C360
N420 G0 Z50 M9
N430 G49
N440 G0 A0
N450 M5
N460 M30
%
