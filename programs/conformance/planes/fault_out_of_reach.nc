; B ends at 100 deg; the underside of the part is beyond.
G68.2 J180
; expect: frame 1 X0 Y0 Z0 B0 C0 turned (1 0 0) (0 -1 0) (0 0 -1)
G53.1
; expect error 4:1 E4354
M30
