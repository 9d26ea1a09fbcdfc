#plane (sideways, 90)
; expect error 1:9 E2001
M30
