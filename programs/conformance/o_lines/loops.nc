; Loops and branches of O-lines; labels say what break and continue mean.
G0
O1 repeat [2.4]
  X[1 + #5]
  #5=[#5 + 1]
O1 endrepeat
; expect: rapid X1
; expect: rapid X2
#1=0
O10 while [#1 LT 3]
  #1=[#1 + 1]
  O11 if [#1 EQ 1]
    Y1
  O11 elseif [#1 EQ 2]
    Y2
  O11 else
    Y3
  O11 endif
O10 endwhile
; expect: rapid Y1
; expect: rapid Y2
; expect: rapid Y3
O20 do
  #1=[#1 - 1]
  O21 repeat [5]
    Z#1
    O20 continue
  O21 endrepeat
  Z100
O20 while [#1]
; expect: rapid Z2
; expect: rapid Z1
; expect: rapid Z0
O30 while [1]
  O31 while [1]
    O30 break
  O31 endwhile
O30 endwhile
N500 O40 if [0] (comment)
  X55
O40 endif (comment) ; and another
/O50 call
{ O50 call }
; expect: rapid X60
; expect: rapid X60
M30
; expect: end and rewind
O50 sub
  X60
O50 endsub
