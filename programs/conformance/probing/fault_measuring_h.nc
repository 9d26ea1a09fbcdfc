; Fanuc has an alarm for H in the block of G37: the offset is the one in force.
G43 H3 G0 Z60
; expect: length H3 0 0 30
; expect: rapid Z60
G37 H3 Z0
M30
; expect error 5:5 E4003
