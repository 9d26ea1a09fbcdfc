; A subprogram that is not here is looked for in a file of its name.
O<bore> call [3]
; expect: rapid Z6
G0 X#<_value>
; expect: rapid X3
M30
; expect: end and rewind
