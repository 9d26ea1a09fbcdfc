G38.3 X1
M30
; expect error 1:1 E4020
