; channel lathe
; A block number that the file does not have.
G71 U1 R0.5
G71 P10 Q20
; expect error 4:1 E4068
N10 G0 X5
M30
