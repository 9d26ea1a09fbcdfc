; `end sub` and `else if` in two words, comments between arguments, EXISTS of a number (LinuxCNC).
O<Hole> call [1] (the depth) [2]
; expect: rapid X1 Y2
M30
; expect: end and rewind
O<Hole> sub
O1 if [#1 EQ 5]
  X5
O1 else if [EXISTS[#2]]
  X#1 Y#2
O1 end if
O<hole> end sub
