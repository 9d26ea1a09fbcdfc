; G53 names points of the machine, whatever offset, tool length and shift hold, for its block only.
T1 M6 G55 G43
; expect: prepare T1
; expect: change T1
; expect: length H1 0 0 10
; expect: frame 2 X100 Y200 Z300 B0 C0
G53 G0 X5 Z10
; expect: rapid X5 Z10 machine
msg (str ($prog_pos[X]) + " " + str ($prog_pos[Y]) + " " + str ($prog_pos[Z]));
; expect: message -95 -200 -300
G1 X0 F100
; expect: line X0 F100
G20 G53 X1
; expect: line X25.4 F100 machine
M30
; expect: end and rewind
