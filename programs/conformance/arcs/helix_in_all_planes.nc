; The third axis moves linearly along; P adds turns.
F200 G17 G0 X10
; expect: rapid X10
G2 X-10 I-10 Z-5
; expect: arc cw xy centre 0,0 X-10 Z-5 F200
G18 G3 Z0 X-5 I2.5 K2.5 Y8 P2
; expect: arc ccw zx centre -2.5,-7.5 turns 2 X-5 Y8 Z0 F200
G19 G2 Y8 Z20 K10 X1
; expect: arc cw yz centre 8,10 X1 Y8 Z20 F200
M30
; expect: end and rewind
