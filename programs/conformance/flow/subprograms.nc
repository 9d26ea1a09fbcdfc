; Numbered programs behind the end, functions, and files.
#include "ramp.nc"
M98 P100 L2
; expect: line X1 F60
; expect: line X2 F60
G0 Y=ramp (0, 10) Z=SAFE_HEIGHT
; expect: rapid Y5 Z50
call ("ramp.nc");
; expect: log ramp
M30
; expect: end and rewind
O100 (one step)
G91 G1 X1 F60
G90
M99
