G51 J-1
; expect error 1:5 E4008
M30
