G51 J0
; expect error 1:5 E4008
M30
