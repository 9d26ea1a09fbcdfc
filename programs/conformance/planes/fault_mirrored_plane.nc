G51.1 X0
G68.2 J10
; expect error 2:1 E4301
M30
