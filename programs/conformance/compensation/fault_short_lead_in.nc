; A lead-in must be longer than the radius: else the tool may start inside the contour.
F100 G41.1 D20 G1 X10
; expect error 2:1 E4144
M30
