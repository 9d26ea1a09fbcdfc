; G44 takes the length of H away: the point moves up by it.
G0 Z100
; expect: rapid Z100
G44 H3
; expect: length H3 0 0 -30
G91 Z0
; expect: rapid Z130
M30
; expect: end and rewind
