; They meet behind the start.
G1 ,A45 F100
X-10 Y0 ,A-90
M30
; expect error 3:1 E4153
