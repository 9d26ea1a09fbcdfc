; G43 H2 while the tool radius is compensated.
F100 G42 D1 G1 X10 Y0
G43 H2
; expect: line X10 Y-1 F100
; expect error 3:1 E4141
M30
