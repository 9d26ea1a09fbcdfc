S1000 M3 F50
; expect: spindle speed 1000
; expect: spindle clockwise 1000
G87 Z-18 R-5 Q0.3
M30
; expect error 4:10 E4062
