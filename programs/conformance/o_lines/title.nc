; A name in capitals before all blocks is the title of the program (LinuxCNC, tests/interp/m98m99).
(a program)
O<Flange>
G0 X1
; expect: rapid X1
M30
; expect: end and rewind
