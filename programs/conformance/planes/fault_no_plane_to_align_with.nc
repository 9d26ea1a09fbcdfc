G53.1
; expect error 1:1 E4350
M30
