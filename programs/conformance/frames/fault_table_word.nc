G10 L20 P1 R3
; expect error 1:12 E4003
M30
