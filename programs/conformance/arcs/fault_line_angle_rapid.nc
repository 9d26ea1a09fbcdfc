; Rapid travel has no angle.
G0 X10 ,A45
M30
; expect error 2:8 E4153
