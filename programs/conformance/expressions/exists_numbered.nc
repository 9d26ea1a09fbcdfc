; EXISTS of numbers, as in the interpreter of LinuxCNC (its test "exists"): 0 where there is none.
#<a>=999
G0 X[EXISTS[#1]] Y[EXISTS[#99999]] Z[EXISTS[#<a>]] B[EXISTS[#<b>]]
; expect: rapid X1 Y0 Z1 B0
#1=2
#2=99999
G0 X[EXISTS[##1]] Y[EXISTS[##2]]
; expect: rapid X1 Y0
M2
; expect: end
