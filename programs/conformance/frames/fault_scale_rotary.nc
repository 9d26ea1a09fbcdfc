G51 B10 P2
; expect error 1:5 E4302
M30
