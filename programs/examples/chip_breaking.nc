%
(BREAK THE CHIP OF A LONG CUT: A MODULATED FEED, THEN AN INTERRUPTED ONE)
(ZERO IN THE CENTRE OF THE FRONT FACE, BAR OF 60 MM)
N10 G21 G90 G18 G7 G40 G54
N20 T0101
N30 G97 S600 M3

(from 0.10 to 0.30 mm/rev and back over 4 mm of path each: the thickness of the chip changes)
N40 G95 G0 X56 Z2
N50 G1 Z-40 Smin=0.10 dS=0.01 dl=0.2 n_s=20

(every 2 mm the tool stands for the time of 0.4 mm, two revolutions: the chip ends)
N60 G0 X58
N70 Z2
N80 X52
N90 G94 G1 Z-40 F120 L_A=0.4 L_B=2

N100 G0 X62 Z5
N110 M5
N120 M30
%
