; Of an included file only functions and constants are known here.
#include "ramp.nc"
G0 Z=SAFE_HEIGHT
passes = 1;
; expect error 4:1 E3001
M30
