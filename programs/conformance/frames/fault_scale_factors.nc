G51 P2 I3
; expect error 1:5 E4304
M30
