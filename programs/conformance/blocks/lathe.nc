; channel lathe
; X is a diameter, the feed per revolution, T changes at once and holds the edge in two digits.
T0201
; expect: prepare T2
; expect: change T2
; expect: length H2 0 0 20
G1 X20 Z-5 F0.1
; expect: line X10 Z-5 F0.1 per revolution
G91 X-4
; expect: line X8 F0.1 per revolution
G90 G8 X3
; expect: line X3 F0.1 per revolution
G94 F50 G2 X8 Z0 I0 K5
; expect: arc cw zx centre 0,3 X8 Z0 F50
M30
; expect: end and rewind
