; channel lathe
; The counter changes by the difference of the overhangs (0 in the table), a radius in G7 too, in the
; program's unit; nothing moves; the next absolute word counts from there; another tool ends it.
T0101
; expect: prepare T1
; expect: change T1
; expect: length H1 0 0 10
G0 X40 Z5
; expect: rapid X20 Z5 per revolution
#tool_overhang (3)
; expect: request sync
; expect: frame 1 X-3 Z0 C0
msg (str ($prog_pos[X]) + " " + str ($overhang));
; expect: message 46 3
G20 #5=1
#tool_overhang (0.5, Z)
; expect: request sync
; expect: frame 1 X0 Z-12.7 C0
G21 G0 X40 Z5
; expect: rapid X20 Z5 per revolution
#tool_overhang ()
; expect: request sync
; expect: frame 1 X0 Z0 C0
msg (str ($prog_pos[Z], 3));
; expect: message -7.700
#tool_overhang (4)
; expect: request sync
; expect: frame 1 X-4 Z0 C0
T0201
; expect: prepare T2
; expect: frame 1 X0 Z0 C0
; expect: change T2
; expect: length H2 0 0 20
M30
; expect: end and rewind
