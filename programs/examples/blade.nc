%
(THE BLADE OF THE EXPERIMENT OUT OF ITS BLANK, FIVE AXES: SCHEME 2)
(ZERO ON THE TABLE AXIS, BLANK 52 X 86 X 40; TOOL 2: BALL MILL 6, SLIM HOLDER)
(generate_programs --out DIR writes Impeller_surface.nc; it finishes, and nothing is roughed out here:)
(its rapids to the beginnings of the bands run through the full blank, which is found)
#include "Impeller_surface.nc"
#workpiece (0, 0.2, 0, 52, 86, 40, 26, 43, 6)//box, milling; zero from its lowest corner
call ("Impeller_surface.nc");
M30
%
