; A negative diameter means the other side, as in the interpreter of LinuxCNC: G41.1 D-2 is G42.1 D2.
G41.1 D-2
G1 X10 F100
; expect: line X10 Y-1 F100
X20
; expect: line X20 Y-1 F100
G40 X30
; expect: line X30 Y0 F100
M30
; expect: end and rewind
