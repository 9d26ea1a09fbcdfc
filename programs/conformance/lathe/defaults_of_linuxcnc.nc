(dialect linuxcnc)
; channel lathe
; LinuxCNC's manual, G codes: G8 and G94 are active when a program begins, on lathes too.
G0 X10 Z5
; expect: rapid X10 Z5
G1 X8 F100
; expect: line X8 F100
G7 X10
; expect: line X5 F100
M2
; expect: end
