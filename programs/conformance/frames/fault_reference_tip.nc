G43.4 H1
; expect: tip H1 0 0 10
; expect: request sync
G28 Z0
; expect error 4:1 E4301
M30
