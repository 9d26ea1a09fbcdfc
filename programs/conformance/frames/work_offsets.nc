; The point stays where it is while the offset changes.
G0 X10 Y20 Z30
; expect: rapid X10 Y20 Z30
G55
; expect: frame 2 X100 Y200 Z300 B0 C0
G91 X0 Z1
; expect: rapid X-90 Z-269
G90 G52 X1 Y2
; expect: frame 2 X101 Y202 Z300 B0 C0
G91 X0
; expect: rapid X-91
G90 G92 X0 Z0
; expect: frame 2 X10 Y202 Z31 B0 C0
X1
; expect: rapid X1
G92.1
; expect: frame 2 X101 Y202 Z300 B0 C0
G53 G0 Z5
; expect: rapid Z5 machine
G91 Z0
; expect: rapid Z-295
M30
; expect: end and rewind
