; Neither the first nor the last plane move of compensation may be an arc.
F100 G42 D1
G2 X10 I5
; expect error 3:1 E4143
M30
