M61 Q9
; expect: set T9
M61 Q10
; expect error 3:5 E5021
M30
