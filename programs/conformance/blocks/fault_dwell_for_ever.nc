; More cycles than can be counted to are no dwell.
G4 P1000000000.0
; expect: dwell 1000000000
G4 P9300000000000000.0
; expect error 4:4 E4008
M30
