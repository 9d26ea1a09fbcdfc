; The order of the words does not matter.
M30 X1 Y2 G1 M9 M3 T2 M6 S500 F100 G21 G90 (MSG,begin)
; expect: message begin
; expect: spindle speed 500
; expect: prepare T2
; expect: change T2
; expect: spindle clockwise 500
; expect: coolant off
; expect: line X1 Y2 F100
; expect: spindle stop 0 $-1
; expect: end and rewind
