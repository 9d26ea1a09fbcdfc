; No point of the line has this coordinate.
G1 X10 ,A90 F100
M30
; expect error 2:8 E4153
