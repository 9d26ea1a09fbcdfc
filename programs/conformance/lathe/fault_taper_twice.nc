(dialect fanuc A)
; channel lathe
; expect error 6:20 E4015
G98 G0 X40. Z2. F100.
; expect: rapid X20 Z2
G90 X36. Z-10. R1. I1.
M30
