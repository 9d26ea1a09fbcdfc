; Letters on a grid of 4 by 6: L is 06 00 40, E is 40 00 06 46 and 03 33; 6 mm high one step is 1 mm, 12
; mm high 2 mm. At 90 deg the line of text runs up, the tops of letters point along -X.
#include "mill/engrave.nc"
G0 X10 Y20 Z5 F100
; expect: rapid X10 Y20 Z5
engrave ("lE", 6, -0.2);
; expect: rapid X10 Y26
; expect: line Z-0.2 F100
; expect: line X10 Y20 F100
; expect: line X14 Y20 F100
; expect: rapid Z5
; expect: rapid X20 Y20
; expect: line Z-0.2 F100
; expect: line X16 Y20 F100
; expect: line X16 Y26 F100
; expect: line X20 Y26 F100
; expect: rapid Z5
; expect: rapid X16 Y23
; expect: line Z-0.2 F100
; expect: line X19 Y23 F100
; expect: rapid Z5
; expect: rapid X22 Y20
engrave ("L", 12, -0.2, 90);
; expect: rapid X10 Y20
; expect: line Z-0.2 F100
; expect: line X22 Y20 F100
; expect: line X22 Y28 F100
; expect: rapid Z5
; expect: rapid X22 Y32
engrave ("1 #", 6, -0.2);
; expect error 58:16 U4403
; expect: request terminate 4403 the font has no letter #
M30
