G7.1 X5
M30
; expect error 1:6 E4302
