G68.4 J10
; expect error 1:1 E4350
M30
