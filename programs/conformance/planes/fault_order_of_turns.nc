G68.2 P1 Q122 I10
; expect error 1:10 E4008
M30
