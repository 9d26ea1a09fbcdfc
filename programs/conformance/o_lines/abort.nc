; (ABORT,text) ends the program with an alarm before its block (LinuxCNC, tests/interp).
#<size>=4
G0 X1
; expect: rapid X1
(abort, size is %.1f#<size>) G0 X2
; expect: request terminate 1000 size is 4.0
; expect error 5:1 U1000
M30
