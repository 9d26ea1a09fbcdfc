(dialect fanuc)
(comments before the first line with % may hold others (as this one) )
%
O1000 (PART (FIRST SIDE))
G0 X10
; expect: rapid X10
M30
; expect: end and rewind
%
