(dialect fanuc A)
; channel lathe
; Steps without a point in thousandths; depth D of a line (Haas); face drilling with R as a distance.
G98 G0 X40. Z2. F100.
; expect: rapid X20 Z2
G75 X38. P500
; expect: line X19.5 F100
; expect: line X19 F100
; expect: rapid X20
G83 Z-3. R-1. Q2.
; expect: rapid Z1
; expect: line Z-1 F100
; expect: rapid Z1
; expect: rapid Z-0.746
; expect: line Z-3 F100
; expect: rapid Z2
G80
X44.
; expect: rapid X22
G71 P10 Q20 U0 W0 D1.
; expect: rapid X21
; expect: line Z-5 F100
; expect: line X22 Z-4 F100
; expect: rapid Z2
; expect: rapid X20
; expect: line Z-5 F100
; expect: rapid X22
; expect: rapid Z2
N10 G0 X40.
N20 G1 Z-5.
M30
; expect: end and rewind
