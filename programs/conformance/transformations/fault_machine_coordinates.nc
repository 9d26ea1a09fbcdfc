G12.1
; expect: transformation polar face C
; expect: request sync
G53 G0 X5
M30
; expect error 4:1 E4301
