(dialect fanuc)
; G41 on the same side with the same offset says nothing new; with another offset it is an error.
G41 D1 G1 X10 Y0 F100
; expect: line X10 Y1 F100
G41 X20
; expect: line X20 Y1 F100
G41 D1 X30
; expect: line X30 Y1 F100
G41 D2 X40
; expect error 9:1 E4142
M30
