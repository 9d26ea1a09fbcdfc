; M7 and M8 may both be on; $ names the spindle.
S1000 M3
; expect: spindle speed 1000
; expect: spindle clockwise 1000
M4 $0
; expect: spindle counter-clockwise 1000
M19 R90
; expect: spindle orient 1000 R90
M5 $-1
; expect: spindle stop 1000 $-1
M7 M8
; expect: coolant mist
; expect: coolant mist flood
M9
; expect: coolant off
M49
; expect: overrides off
M0
; expect: program stop
; expect: request sync
M30
; expect: overrides on
; expect: end and rewind
