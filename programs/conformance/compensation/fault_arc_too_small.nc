; The tool lies inside the arc that leads in and is too large for it.
F100 G41.1 D30
G3 X10 Y10 J10
M30
; expect error 3:1 E4145
