; An operand has a sign of its own, also directly behind an operator (LinuxCNC, overview of the
; interpreter, "Expressions and binary operators": real values begin with an optional sign).
#1 = 2
#2 = [.75--24.75*#1]
#3 = [1++#1]
#4 = [1+-#1]
G0 X#2 Y#3 Z#4
; expect: rapid X50.25 Y3 Z-1
#5 = 5--#1
G0 X[--#1] Y#5
; expect: rapid X2 Y7
M30
; expect: end and rewind
