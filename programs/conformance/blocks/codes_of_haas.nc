(dialect haas)
; Haas mill operator's manual: G110 to G129 are G154 P1 to P20, M16 changes the tool as M6 does,
; M59 and M69 switch the output that P names by its number or its variable (M59 P90 is #12090=1), M76
; and M77 the display.
G110
; expect: frame 10 X0 Y0 Z0 B0 C0
G129
; expect: frame 29 X0 Y0 Z0 B0 C0
G54
; expect: frame 1 X0 Y0 Z0 B0 C0
T2 M16
; expect: prepare T2
; expect: change T2
M59 P1104
; expect: output 4 1
M69 P12004
; expect: output 4 0
M59 P2
; expect: output 2 1
M69 P2
; expect: output 2 0
M76
M77
M30
; expect: end and rewind
