G16
G0 @5
M30
; expect error 2:4 E4301
