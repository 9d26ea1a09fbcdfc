; channel grind
; A grinding channel has the codes of a mill, but the plane ZX.
msg (str ($g[2]) + " " + str ($g[5]) + " " + str ($g[15]));
; expect: message 18 94 8
G81 X1 Y-1 Z2 R1 F100
; expect: rapid Y1
; expect: rapid X1 Z2
; expect: line Y-1 F100
; expect: rapid Y1
M30
; expect: end and rewind
