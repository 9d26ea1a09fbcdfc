(dialect haas)
; Haas operator's manual, groups of G codes: G54 to G59 are of group 12. #4107 is D, #4130 P of G54.1.
G0 G55
; expect: frame 2 X100 Y200 Z300 B0 C0
X#4012 Y#4130
; expect: rapid X55 Y0
D5
G54.1 P7
; expect: frame 16 X0 Y0 Z0 B0 C0
X#4107 Y#4130
; expect: rapid X5 Y7
M30
; expect: end and rewind
