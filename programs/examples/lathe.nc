%
(TURN A SHOULDER, MILL A HEXAGON ON THE FACE AND A GROOVE ROUND THE SIDE)
(ZERO IN THE CENTRE OF THE FRONT FACE, BAR OF 60 MM; SPINDLE 2 IS THE DRIVEN TOOL)
N10 G21 G90 G18 G7 G40 G54
N20 T0101

(shoulder of 50 mm diameter)
N30 G97 S800 M3
N40 G95 G0 X54 Z2
N50 G1 Z-30 F0.25
N60 X62
N70 G0 Z5
N80 M5

(hexagon, 36 mm across flats, on the face: the spindle becomes C)
N90 M902 H1=1
N100 $2 S4000 M3
N110 G94 G8 G0 X30 Z-2 C0
N120 G12.1
num side = 0;
num across = 36;
num corner = across / sqrt (3);
N130 G64 P0.01 G1 X=corner C0 F1200
for (side = 1; side <= 6; side++)
{
  G1 X=corner*cos (60*side) C=corner*sin (60*side)
}
N140 G0 X40 C0
N150 G13.1

(groove in a wave round the side: 360 deg of C are the circumference of 50 mm)
N160 G0 X30 Z-15 C0
N170 G7.1 C25
N180 G1 X23 F600
num angle = 0;
for (angle = 5; angle <= 360; angle = angle + 5)
{
  G1 C=angle Z=-15+3*sin (3*angle)
}
N190 G1 X30
N200 G13.1

N210 $2 M5
N220 M903
N230 G0 X80 Z100
N240 M30
%
