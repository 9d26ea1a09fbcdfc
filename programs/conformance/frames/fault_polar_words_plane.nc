G18 G0 @5
M30
; expect error 1:8 E4301
