#plane (spatial, 90, 0)
; expect error 1:1 E3005
M30
