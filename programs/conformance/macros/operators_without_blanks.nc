(dialect fanuc)
; An operator and a function without a blank between them.
#1=-3
#2=5
IF[ABS[#1]LEABS[#2]]GOTO10
X9
N10 G0 X[7MODFIX[4.5]] Y[#2*2MODFUP[2.5]]
; expect: rapid X3 Y1
M30
; expect: end and rewind
