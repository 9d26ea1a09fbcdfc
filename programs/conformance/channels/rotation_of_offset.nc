; The rotation of a work offset is read and written beside its axes; it is an angle, in G20 too.
G20
settable_zs (1, 2, "R", 5);
; expect: request write offset channel 1 2 5
num turned = gettable_zs (1, 2, "R");
; expect: request read offset channel 1 2
G21
G0 X=turned
; expect: rapid X2
M30
; expect: end and rewind
