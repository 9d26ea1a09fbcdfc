%
(THE CAR OF THE EXPERIMENT OUT OF ITS BLANK: ROUGHING HERE, FINISHING BY 0003_MB_3D.NC)
(ZERO ON THE ROOF, BLANK 52 X 86 X 37; TOOL 3: END MILL 6, TOOL 1: BALL MILL 6, LONG)
(generate_programs --out DIR writes 0003_MB_3D.nc)
#include "0003_MB_3D.nc"
#workpiece (0, 0.2, 0, 52, 86, 37, 26, 43, 37)//box, milling; zero from its lowest corner

//0 up to rise, 1 from rise_end to fall, 0 from fall_end on
num ramp (num part)
{
  if (part <= 0) {return 0;}
  if (part >= 1) {return 1;}
  return part*part*(3 - 2*part);
}
num plateau (num at, num rise, num rise_end, num fall, num fall_end)
{
  return ramp ((at - rise)/(rise_end - rise))*(1 - ramp ((at - fall)/(fall_end - fall)));
}
//what the end mill does not go below: body and cabin, wider by its radius
num height (num xpos, num ypos)
{
  num body = plateau (ypos, -46, -28, 29, 46)*plateau (xpos, -28, -16, 16, 28);
  num cabin = plateau (ypos, -22, -5, 17, 35)*plateau (xpos, -22, -10, 10, 22);
  return 18.5*body + 16*cabin - 30.5;
}

N10 G21 G90 G17 G40 G49 G80 G54
N20 T3 M6
N30 S9000 M3
N40 G0 X-26 Y-47
N50 G43 H3 Z50
N60 G64 P0.1
num level = 0;
num row = 0;
num along = 0;
num way = 1;
num depth = 0;
for (level = -5; level >= -30; level = level - 5)
{
  for (row = -26; row <= 26; row = row + 4)
  {
    G0 Z5
    G0 X=row Y=-47*way
    G0 Z=level + 0.5
    for (along = -46; along <= 46; along = along + 2)
    {
      depth = height (row, along*way);
      if (depth < level) {depth = level;}
      G1 X=row Y=along*way Z=depth F3000
    }
    way = -way;
  }
}
N70 G0 Z50
N80 G49 M5
call ("0003_MB_3D.nc");
M30
%
