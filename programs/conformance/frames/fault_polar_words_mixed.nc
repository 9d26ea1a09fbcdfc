G0 @5 ^30 X3
M30
; expect error 1:4 E4304
