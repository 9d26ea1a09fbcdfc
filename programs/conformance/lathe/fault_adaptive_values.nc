; channel lathe
#adaptive (oscillate, 100)
M30
; expect error 2:1 E3005
