G68 I0 J0 R30
; expect error 1:1 E4305
M30
