; Where a value ends: an expression goes on behind blanks, `(` is a comment where an operator may
; stand, `//` always is one; RS274 values have a sign of their own.
num aa = 5, bb = 2;
#<deep>=4
G0 X=aa -bb Y=aa -(bb)
; expect: rapid X3 Y3
X=aa (-bb) Y=abs (-bb) (comment) Z=(aa+1)/2 (comment)
; expect: rapid X5 Y2 Z3
X=8//2
; expect: rapid X8
X-#<deep> Y- #<deep> Z+[#<deep> - 1]
; expect: rapid X-4 Y-4 Z3
Xsin[30] Y-cos[60]
; expect: rapid X0.5 Y-0.5
X=-aa ** 2 Y=2 ** 3 ** 2 Z=-7 % 3
; expect: rapid X-25 Y512 Z2
G=bb - 1 F=100 M=aa + 3 X 1
; expect: coolant flood
; expect: line X1 F100
M30
; expect: coolant off
; expect: end and rewind
