(dialect fanuc)
; Blanks in a block have no meaning (Fanuc B-64304EN, 11.2, "Program section configuration"; Haas mill
; operator's manual, "Program structure"): `# 5` and `# [..]` are the variables #5 and #[..].
# 5 = 3
#6 = # 5 + 1
# [ #5 + 4 ] = 2. * # [ 6 ]
G0 X# 5 Y [ # [ 2 + 3 ] * 2 ] Z - # 7
; expect: rapid X3 Y6 Z-8
IF [ # 5 EQ 3 ] GOTO # 6
X0
N4 X1
; expect: rapid X1
M30
; expect: end and rewind
