(dialect haas A)
; channel lathe
; expect error 6:14 E4150
G98 G0 X20. Z0. F100.
; expect: rapid X10 Z0
G1 X30. Z-5. K1.
Z-20.
M30
