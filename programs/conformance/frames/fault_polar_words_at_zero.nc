G91 G0 ^5
M30
; expect error 1:8 E4008
