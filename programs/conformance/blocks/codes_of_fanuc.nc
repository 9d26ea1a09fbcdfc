(dialect fanuc)
; Fanuc B-64304EN-2: G8 P, G5.1 Q R and G5 P switch look-ahead, G23 a zone that is not there, G54 P1 is
; G54.1 P1; G112, G113, G107 are other numbers of G12.1, G13.1, G7.1.
G8 P1
G5.1 Q1 R5
G23
G54 P1
; expect: frame 10 X0 Y0 Z0 B0 C0
G54
; expect: frame 1 X0 Y0 Z0 B0 C0
G5.1 Q0
G8 P0
M30
; expect: end and rewind
