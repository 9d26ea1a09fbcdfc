; G65 hands its words over as numbered parameters of the macro alone; L repeats, and G counts not as a word.
#1=50
G65 P300 A5 X2 L2
; expect: rapid X5 Y2
; expect: rapid X5 Y2
G0 X#1
; expect: rapid X50
M30
; expect: end and rewind
O300
G0 X#1 Y#24
#1=99
M99
