; What a block sets holds for its own motion, and takes effect in a fixed order, wherever it stands.
T1 M6
; expect: prepare T1
; expect: change T1
G2 X10 Z10 I10 K0 G91 G61 G55 G43 H1 G18 F0.2 G95 M3 S50
; expect: spindle speed 50
; expect: spindle clockwise 50
; expect: length H1 0 0 10
; expect: frame 2 X100 Y200 Z300 B0 C0
; expect: arc cw zx centre -310,-90 X-90 Z-300 F0.2 per revolution exact path
M0 M8 G4 P2 G0 X1 G90 G54 G49
; expect: coolant flood
; expect: dwell 2
; expect: length off
; expect: frame 1 X0 Y0 Z0 B0 C0
; expect: rapid X1 per revolution exact path
; expect: program stop
; expect: request sync
M30
; expect: spindle stop 0 $-1
; expect: coolant off
; expect: end and rewind
