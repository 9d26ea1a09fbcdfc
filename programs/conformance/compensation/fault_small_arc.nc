; The inside of an arc smaller than the tool; what comes before it is executed.
F100 G41.1 D10 G1 X10
; expect: line X10 Y5 F100
X40
; expect: line X40 Y5 F100
G3 X44 Y4 J4
; expect error 6:1 E4145
M30
