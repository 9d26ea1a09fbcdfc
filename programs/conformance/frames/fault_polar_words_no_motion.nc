G92 @5 ^0
M30
; expect error 1:5 E4301
