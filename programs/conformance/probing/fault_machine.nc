G53 G38.2 X1 F50
M30
; expect error 1:1 E4041
