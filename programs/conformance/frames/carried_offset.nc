; G54.2: the rotary table carries the work offset. Here C turns about X100 Y0, and the offset lies at
; X100 Y200 with the table at C0, so 200 from the centre. A coordinate that is not programmed stays:
; its axis follows. C takes the shortest way: 270 is -90.
G54.2 P2
; expect: frame 2 X100 Y200 Z300 B0 C0
G0 X1 Y2 C90
; expect: frame 2 X-100 Y0 Z300 B0 C0
; expect: rapid X1 Y2 C90
C270
; expect: frame 2 X300 Y0 Z300 B0 C0
; expect: rapid X1 C-90
G91 G1 X3 B5 F600
; expect: line X4 B5 F600
G90 G54.2 P0
; expect: frame 2 X100 Y200 Z300 B0 C0
G54
; expect: frame 1 X0 Y0 Z0 B0 C0
M30
; expect: end and rewind
