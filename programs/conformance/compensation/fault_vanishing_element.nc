; The bottom of a groove narrower than the tool. The message names the bottom.
F100 G0 X10 Y30
; expect: rapid X10 Y30
G41.1 D10 G1 X0 Y20
; expect: line X5 Y20 F100
Y0
; expect: line X5 Y5 F100
X9
; expect error 8:1 E4147
Y20
X20
M30
