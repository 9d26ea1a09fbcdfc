(dialect fanuc)
; ROUND works on whole numbers in computations and on the least input increment in words
; (B-63944EN, 16.2): 0.001 mm or deg, 0.0001 inch.
G0
#1=1.2345
#2=2.3456
X[#1+#2]
; expect: rapid X3.5801
X[ROUND[#1]+ROUND[#2]]
; expect: rapid X3.581
XROUND[#2] Y-ROUND[#1]
; expect: rapid X2.346 Y-1.235
C[ROUND[10.12345]]
; expect: rapid C10.123
#3=ROUND[#2]
X#3 Y[#3+0.5]
; expect: rapid X2 Y2.5
IF [ROUND[#1] EQ 1] THEN X1
; expect: rapid X1
S[ROUND[123.4]]
; expect: spindle speed 123
G20
X[ROUND[1.23456]]
; expect: rapid X31.35884
C[ROUND[10.12345]]
; expect: rapid C10.123
M30
; expect: end and rewind
