; On a cylinder of 180/pi mm a degree of C is a millimetre of its surface; J runs along C, K along Z,
; whichever plane is active. Seen from outside G3 turns from C to Z.
G18 G7.1 C=180/PI
; expect: transformation cylinder 57.29577951 C
; expect: request sync
G3 C10 Z10 K10 F100
; expect: arc ccw yz centre 0,10 Z10 C10 F100
G2 C20 Z0 R10
; expect: arc cw yz centre 10,0 Z0 C20 F100
G91 G90.1 G2 C0 J20 K-5
; expect: arc cw yz centre 20,-5 C20 F100
G13.1
; expect: transformation off
; expect: request sync
M30
; expect: end and rewind
