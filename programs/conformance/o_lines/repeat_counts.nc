; A count is rounded; none or less runs not at all; `while` looks before, `do` behind.
#1=0
O1 repeat [-3]
  #1=[#1 + 100]
O1 endrepeat
O2 repeat [1.6]
  #1=[#1 + 1]
O2 endrepeat
O3 while [0]
  #1=[#1 + 100]
O3 endwhile
O4 do
  #1=[#1 + 10]
O4 while [0]
G0 X#1
; expect: rapid X12
O5 if [0.5]
  Y1
O5 endif
; expect: rapid Y1
M30
; expect: end and rewind
