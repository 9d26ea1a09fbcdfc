#adaptive (force, 1200)
M30
; expect error 1:1 E6060
