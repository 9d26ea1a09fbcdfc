%
(A HOLE OF 40 MM, 12 MM DEEP, MILLED ON A HELIX WITH ONE BLOCK)
(ZERO ON THE TOP FACE IN THE MIDDLE OF THE HOLE, TOOL 1: END MILL OF 10 MM)
N10 G21 G90 G17 G40 G49 G80
N20 T1 M6
N30 S6000 M3
N40 G54
N50 G0 X0 Y0
N60 G43 H1 Z50
N70 G64 P0.01
N80 G0 Z1 M8
N90 G1 Z0 F300

(To the wall on a half circle, so that it is touched along its tangent)
N100 G3 X15 Y0 I7.5 F900
(Six turns, 2 mm deeper each)
N110 G3 X15 Y0 Z-12 I-15 P6
(One turn at full depth cleans the bottom)
N120 G3 I-15
(Back to the middle on a half circle, then out)
N130 G3 X0 Y0 I-7.5
N140 G0 Z50 M9
N150 G49 M5
N160 M30
%
