; M98 shares #1 to #30 with its caller, repeats, and finds P in this file before the files.
#1=1
M98 P30100
; expect: rapid X1
; expect: rapid X2
; expect: rapid X3
M98 P100 L2
; expect: rapid X4
; expect: rapid X5
M98 P100 L0
M98 P200
; expect: rapid Y7
M198 P0100
; expect: rapid Z0
M98 P#1
M30
; expect error 15:1 E7005
O100
#1=[#1 + 1] G0 X#1
M99
