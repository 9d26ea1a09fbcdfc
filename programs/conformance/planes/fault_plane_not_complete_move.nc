G0 X1
; expect: rapid X1
G68.2 P3 Q1 I1
X10
; expect error 4:1 E4352
M30
