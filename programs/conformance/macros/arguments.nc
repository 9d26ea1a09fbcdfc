(dialect fanuc)
; Arguments of specification I and II (B-63944EN, 16.6.1).
G0
G65 P100 A1 B2 C3 I4 J5 K6 D7 E8 F9 H11 M13 Q17 R18 S19 T20 U21 V22 W23 X24 Y25 Z26
; expect: rapid X1 Y2 Z3
; expect: rapid X4 Y5 Z6
; expect: rapid X7 Y8 Z9
; expect: rapid X11 Y13 Z17
; expect: rapid X18 Y19 Z20
; expect: rapid X21 Y22 Z23
; expect: rapid X24 Y25 Z26
G65 P200 A1 I4 J5 K6 I7 K9 I10 J11 K12
; expect: rapid X4 Y5 Z6
; expect: rapid X7 Z9
; expect: rapid X10 Y11 Z12
; Of two words for one variable the later one holds (the manual's example: #7 is 5).
G65 P300 A1 B2 I-3 I4 D5
; expect: rapid X1 Y2 Z-3
; expect: rapid X5
G65 P300 A1 B2 D5 I-3 I4
; expect: rapid X1 Y2 Z-3
; expect: rapid X4
M30
; expect: end and rewind
O100
X#1 Y#2 Z#3
X#4 Y#5 Z#6
X#7 Y#8 Z#9
X#11 Y#13 Z#17
X#18 Y#19 Z#20
X#21 Y#22 Z#23
X#24 Y#25 Z#26
M99
O200
X#4 Y#5 Z#6
X#7 Y#8 Z#9
X#10 Y#11 Z#12
M99
O300
X#1 Y#2 Z#4
X#7
M99
