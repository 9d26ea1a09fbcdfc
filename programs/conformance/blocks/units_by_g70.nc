; On a mill G70 and G71 are G20 and G21, for their own block too.
G0 X1 G70
; expect: rapid X25.4
X2
; expect: rapid X50.8
G71 X3
; expect: rapid X3
msg (str ($g[6]));
; expect: message 21
M30
; expect: end and rewind
