G7.1
M30
; expect error 1:1 E4007
