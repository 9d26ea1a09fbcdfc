; Over the intermediate point to the stored point in machine coordinates, named axes only.
G0 X10 Y20 Z30
; expect: rapid X10 Y20 Z30
G28.1
G55
; expect: frame 2 X100 Y200 Z300 B0 C0
G0 X0 Y0 Z0 B5
; expect: rapid X0 Y0 Z0 B5
G28 X1 Z2
; expect: rapid X1 Z2
; expect: rapid X10 Z30 machine
msg (str ($prog_pos[X]) + " " + str (#5161) + " " + str (#5163));
; expect: message -90 10 30
; In G91 the words are distances; all axes without words.
G91 G28 Z1
; expect: rapid Z-269
; expect: rapid Z30 machine
G28
; expect: rapid X10 Y20 Z30 B0 C0 machine
#5182=77
G30 Y0
; expect: rapid Y-180
; expect: rapid Y77 machine
G90 G30.1 P3
G0 Y0
; expect: rapid Y0
G30 P3 Y1
; expect: rapid Y1
; expect: rapid Y77 machine
M30
; expect: end and rewind
