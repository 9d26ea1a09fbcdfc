$PART.MIN%
G15 H1
VC1=5
M30
; expect error 1:1 E2042
