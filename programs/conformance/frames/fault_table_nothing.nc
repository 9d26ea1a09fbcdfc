G10 L2 P1
; expect error 1:1 E4007
M30
