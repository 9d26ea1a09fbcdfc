; G68 turns the plane about a centre; the point stays where it is.
G0 X10 Y0
; expect: rapid X10 Y0
G68 X10 Y0 R90
; expect: frame 1 X10 Y-10 Z0 B0 C0 turned (0 -1 0) (1 0 0) (0 0 1)
; The point is the centre: it keeps its name. A step in X goes along Y of the base.
G91 G0 X5 (base: X10 Y5)
; expect: rapid X15
G90 G69
; expect: frame 1 X0 Y0 Z0 B0 C0
G91 Y1
; expect: rapid Y6
; Words left out of the centre mean the point where the axes stand.
G90 G68 R180
; expect: frame 1 X20 Y12 Z0 B0 C0 turned (-1 0 0) (0 -1 0) (0 0 1)
X11
; expect: rapid X11
; A new rotation replaces the old one: base X9 Y6 is the centre now.
G68 R90
; expect: frame 1 X15 Y-3 Z0 B0 C0 turned (0 -1 0) (1 0 0) (0 0 1)
; G52 moves the turned system with its centre, G92 names the point.
G52 X100
; expect: frame 1 X115 Y-3 Z0 B0 C0 turned (0 -1 0) (1 0 0) (0 0 1)
G92 X0 Y0
; expect: frame 1 X9 Y6 Z0 B0 C0 turned (0 -1 0) (1 0 0) (0 0 1)
X1
; expect: rapid X1
G53 X0
; expect: rapid X0 machine
; Base X0 Y7: X of the turned system is along Y from 6, Y against X from 9.
G91 X0 Y0
; expect: rapid X1 Y9
M30
; expect: end and rewind
