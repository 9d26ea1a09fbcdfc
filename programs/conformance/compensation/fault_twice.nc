; G41 X1 while the tool radius is compensated.
F100 G42 D1 G1 X10 Y0
G41 X1
; expect: line X10 Y-1 F100
; expect error 3:1 E4142
M30
