; Lines of one direction do not meet.
G1 ,A45 F100
X10 Y0 ,A225
M30
; expect error 3:1 E4153
