%
(THE BLADE OF THE EXPERIMENT OUT OF ITS BLANK, SCHEME 2: ROUGHING HERE, WITH B AND C AT 0,)
(FINISHING WITH FIVE AXES BY IMPELLER_SURFACE.NC)
(ZERO ON THE TABLE AXIS, BLANK 52 X 86 X 40; TOOL 3: END MILL 6, TOOL 2: BALL MILL 6, SLIM HOLDER)
(generate_programs --out DIR writes Impeller_surface.nc)
#include "Impeller_surface.nc"
#workpiece (0, 0.2, 0, 52, 86, 40, 26, 43, 6)//box, milling; zero from its lowest corner

//the blade as its generator shapes it: programs/generators/impeller_blade.cc
num surface (num xpos, num ypos)
{
  num along_x = (xpos + 26)*0.97424 - 27.511;//its zone of 52 x 86 x 34 mm, taken back
  num along_y = ypos*1.05814;
  num bend = -0.46*along_x - 0.0035*along_x*along_x + 0.0035*along_y*along_y + 0.0012*along_x*along_y;
  num wave = 0.5*sin (6.42857*along_y)*cos (3.43775*along_x);
  return (bend + wave + 12.4604)*1.09064;
}
num higher (num one, num other)
{
  if (one > other) {return one;}
  return other;
}
//what the end mill does not go below: the blade beneath its radius, and 0.7 mm for the finishing
num height (num xpos, num ypos)
{
  num highest = higher (surface (xpos - 3, ypos), surface (xpos + 3, ypos));
  highest = higher (highest, higher (surface (xpos, ypos - 3), surface (xpos, ypos + 3)));
  highest = higher (highest, higher (surface (xpos - 2.1, ypos - 2.1), surface (xpos + 2.1, ypos + 2.1)));
  highest = higher (highest, higher (surface (xpos - 2.1, ypos + 2.1), surface (xpos + 2.1, ypos - 2.1)));
  return highest + 0.7;
}

N10 G21 G90 G17 G40 G49 G80 G54
N20 T3 M6
N30 S9000 M3
N40 G0 X-28 Y-47 B0 C0
N50 G43 H3 Z60
N60 G64 P0.1
num level = 0;
num row = 0;
num along = 0;
num way = 1;
num depth = 0;
for (level = 29; level >= -1; level = level - 5)
{
  for (row = -28; row <= 28; row = row + 2)
  {
    G0 Z39
    G0 X=row Y=-47*way
    depth = height (row, -47*way);
    if (depth < level) {depth = level;}
    G0 Z=depth + 0.5
    for (along = -46; along <= 46; along = along + 2)
    {
      depth = height (row, along*way);
      if (depth < level) {depth = level;}
      G1 X=row Y=along*way Z=depth F3000
    }
    way = -way;
  }
}
N70 G0 Z60
N80 G49 M5
call ("Impeller_surface.nc");
M30
%
