F100 G5.3
M30
; expect error 1:6 E4312
