; Arguments are #1, #2 ... of the call; what is left out is 0, and the caller's come back.
#1=7 #2=8 #<own>=3
O100 call [10] [#1 + 1]
; expect: rapid X10 Y8 Z0
G0 X#1 Y#2 Z#<own>
; expect: rapid X7 Y8 Z3
X[#<_value>] Y#<_value_returned>
; expect: rapid X18 Y1
O<No value> call
X#<_value> Y#<_value_returned> Z[EXISTS[#<left>] + 10 * EXISTS[#<_kept>]]
; expect: rapid X0 Y0 Z10
Y#<_kept>
; expect: rapid Y5
O[50 * 2] call [1] [2] [3]
; expect: rapid X1 Y2 Z3
M30
; expect: end and rewind
O0100 sub (a number with leading zeros is the same number)
  G0 X#1 Y#2 Z#3
  #1=99 #<own>=4
  O101 if [#1 GT 50]
    O100 return [#2 + 10] ; the rest is not reached
  O101 endif
  X1000
O100 endsub [0]
o<novalue> sub
  #<left>=1
  #<_kept>=5
o<novalue> endsub
