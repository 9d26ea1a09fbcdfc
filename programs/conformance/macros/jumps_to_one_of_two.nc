(dialect fanuc)
; Of blocks with one number the first behind the jump is meant, or else the first of the program
; (B-63944EN, 16.5.2: the search goes on to the end, then from the beginning).
N10 G0 X1
#1=#1+1
IF [#1 GT 1] GOTO 30
N20 X2
GOTO 20
X9
N20 X3
IF [#2 EQ #0] GOTO 25
X9
N25 #2=1
GOTO 10
N30 X4
M30
; expect: rapid X1
; expect: rapid X2
; expect: rapid X3
; expect: rapid X1
; expect: rapid X4
; expect: end and rewind
