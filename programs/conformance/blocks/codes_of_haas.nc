(dialect haas)
; Haas mill operator's manual: G110 to G129 are G154 P1 to P20, M16 changes the tool as M6 does.
G110
; expect: frame 10 X0 Y0 Z0 B0 C0
G129
; expect: frame 29 X0 Y0 Z0 B0 C0
G54
; expect: frame 1 X0 Y0 Z0 B0 C0
T2 M16
; expect: prepare T2
; expect: change T2
M30
; expect: end and rewind
