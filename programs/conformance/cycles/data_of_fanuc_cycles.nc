(dialect fanuc)
; P and Q of one cycle stay for the next until G80 (B-63944EN, 13.1): G81 uses neither.
G0 Z10 F100
; expect: rapid Z10
G81 X1 Z-5 R2 P500 Q2
; expect: rapid X1
; expect: rapid Z2
; expect: line Z-5 F100
; expect: rapid Z10
G82 X2
; expect: rapid X2
; expect: rapid Z2
; expect: line Z-5 F100
; expect: dwell 0.5
; expect: rapid Z10
G80
M30
; expect: end and rewind
