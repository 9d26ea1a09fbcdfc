; A line that sets the modes of all groups has more than eight G codes.
G0 G17 G21 G40 G49 G50 G54 G64 G69 G80 G90 G91.1 G94 G97 G98
X10
; expect: rapid X10
M30
; expect: end and rewind
