G68 X0 Y0
; expect error 1:1 E4007
M30
