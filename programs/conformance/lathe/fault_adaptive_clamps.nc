; channel lathe
#adaptive (force, 1200, 0.6, 0.05)
M30
; expect error 2:1 E6061
