(dialect fanuc)
; A code of a vacant variable is left out, as any word of one (B-63944EN, 16.1).
G0 X1
; expect: rapid X1
G#1 M#2 X2
; expect: rapid X2
#1=1
G#1 X3 F100
; expect: line X3 F100
G[#1+#2] M[#3+8] X4
; expect: coolant flood
; expect: line X4 F100
M30
; expect: coolant off
; expect: end and rewind
