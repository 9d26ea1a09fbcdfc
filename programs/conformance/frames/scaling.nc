; Words are scaled about the centre; the axes stand still while the factor changes.
G0 X10 Y10 Z10
; expect: rapid X10 Y10 Z10
G51 X4 Y0 Z10 P0.5
X10 Y10 Z12
; expect: rapid X7 Y5 Z11
msg (str ($prog_pos[X]));
; expect: message 10
G91 X2
; expect: rapid X8
; Distances of the centre and radii are scaled, too; the feed is not.
G90 G3 X12 Y14 J2 F100
; expect: arc ccw xy centre 8,6 X8 Y7 F100
G2 X12 Y10 R2
; expect: arc cw xy centre 8,6 X8 Y5 F100
G90.1 G3 X12 Y14 I12 J12
; expect: arc ccw xy centre 8,6 X8 Y7 F100
; Without a centre the point where the axes stand is the centre.
G51 I3
G91 G1 X1 Y1
; expect: line X11 Y8 F100
G90 G50 X1
; expect: line X1 F100
M30
; expect: end and rewind
