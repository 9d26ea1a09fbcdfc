; A value that cannot be computed stops before its block, settings of the block included.
#1=1 #2=0
G0 X#1
; expect: rapid X1
M8 #1=5 G0 X[#1 / #2]
; expect error 5:14 E3008
M30
