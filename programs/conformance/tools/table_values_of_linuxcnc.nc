(dialect linuxcnc)
; #5401 to #5403 are the lengths of the loaded tool in the table, "not affected by G43 or G49".
T2 M6
G49
; expect: prepare T2
; expect: change T2
G0 Z#5403
; expect: rapid Z20
G43
; expect: length H2 0 0 20
X[#5403/2]
; expect: rapid X10
M2
; expect: end
