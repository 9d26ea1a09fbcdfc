G54.4
; expect error 1:1 E4007
M30
