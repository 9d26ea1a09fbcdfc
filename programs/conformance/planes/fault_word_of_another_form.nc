G68.2 J10 R5
; expect error 1:11 E4003
M30
