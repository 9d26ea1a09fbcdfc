; Each override by itself; the end of the program gives all of them back.
M50 P0
; expect: spindle override only
M51 P0
; expect: overrides off
M50
; expect: feed override only
M51 P1
; expect: overrides on
M52
; expect: overrides on adaptive
M53 P0
; expect: overrides on adaptive no feed stop
M30
; expect: overrides on
; expect: end and rewind
