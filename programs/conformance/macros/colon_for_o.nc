(dialect fanuc)
; A colon stands for O (B-63944EN, 13.1: ISO code).
:0100(MAIN)
M98 P200
; expect: rapid X5
M30
; expect: end and rewind
:200
G0 X5
M99
