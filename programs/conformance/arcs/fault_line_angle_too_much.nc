; Both coordinates and an angle say too much.
G1 X10 Y10 ,A45 F100
M30
; expect error 2:1 E4153
