; Numbered parameters show tables and position; positions in the units of the program.
G55 G0 X10 Y20
; expect: frame 2 X100 Y200 Z300 B0 C0
; expect: rapid X10 Y20
msg (str (#5220) + " " + str (#5241) + " " + str (#5243) + " " + str (#5420) + " " + str (#5421));
; expect: message 2 100 300 10 20
G92 X4
; expect: frame 2 X106 Y200 Z300 B0 C0
msg (str (#5211) + " " + str (#5210));
; expect: message 6 1
; Positions are those that words would have: before scaling, in diameters, in inches.
G51 X4 Y0 P2
G0 X6
; expect: rapid X8
G7 G20
msg (str (#5420*25.4, 6) + " " + str ($prog_pos[X]*25.4, 6) + " " + str (#<_y>*25.4, 6));
; expect: message 12.000000 12.000000 10.000000
M30
; expect: end and rewind
