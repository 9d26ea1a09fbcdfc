; The lines meet in (10,1): the chamfer takes more than there is of the second one.
G1 X10 ,C2 F100
; expect: line X8 Y0 F100
,A90
; expect: line X10 Y2 F100
X0 Y11 ,A135
M30
; expect error 6:1 E4153
