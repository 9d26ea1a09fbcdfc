(dialect fanuc)
; A skip to where the axes stand moves nothing and finds nothing: the skip signal position is the end of
; the block (Fanuc B-64304EN, 16.2, "Position information").
G0 X5
; expect: rapid X5
G31 X5 F100
#1=#5061
X[#1+1]
; expect: rapid X6
G31 X6.005
; expect: line X6.005 F100
M30
; expect: end and rewind
