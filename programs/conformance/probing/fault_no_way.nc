G0 X1
; expect: rapid X1
G38.2 X1 F50
M30
; expect error 3:1 E4321
