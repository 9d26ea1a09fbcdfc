G68 X0 Y0 R360
G12.1
M30
; expect error 2:1 E4301
