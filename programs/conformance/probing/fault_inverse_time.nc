G93 G38.2 X1 F50
M30
; expect error 1:5 E4301
