; 0 would be no limit.
G26 S0
; expect error 2:5 E4058
M30
