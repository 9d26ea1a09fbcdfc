G68.2 P2 Q1 X0 Y0
; expect error 1:1 E4007
M30
