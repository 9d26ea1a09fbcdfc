; The line whose end is not known ends at a line with end and angle.
G1 ,A45 F100
X10 Y0
M30
; expect error 3:1 E4153
