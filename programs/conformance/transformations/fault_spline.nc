G12.1
; expect: transformation polar face C
; expect: request sync
G1 X20 C0 F100
; expect: line X20 C0 F100
G5 X25 Y10 I2 J3 P-2 Q-3
M30
; expect error 6:1 E4301
