; channel lathe
; G96 needs a cutting speed: the last speed in 1/min is none.
S500
; expect: spindle speed 500
G96 D1000
; expect error 5:1 E4054
M30
