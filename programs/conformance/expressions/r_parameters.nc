; R-parameters are set behind their block, computed ones first; # and R are operands of both kinds.
R1=10 R2=R1+1
G0 X=R1 Y=R2
; expect: rapid X10 Y1
R1=20 X=R1
; expect: rapid X10
#7=3 #<own>=4
X=R1+#7*2 Y=#<own>-1 Z=#[2+5]
; expect: rapid X26 Y3 Z3
num wide = #7 ** 2;
X=wide
; expect: rapid X9
M30
; expect: end and rewind
