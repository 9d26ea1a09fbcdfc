; The speed of an earlier block is no limit.
S500
; expect: spindle speed 500
G26
; expect error 4:1 E4007
M30
