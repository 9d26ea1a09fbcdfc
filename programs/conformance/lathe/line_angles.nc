; channel lathe
; On lathes the angle leads from Z towards X: a taper of 45 deg, then of 30 deg to the axis.
G8 G18 G94 F200 G0 X10 Z0
; expect: rapid X10 Z0
G1 Z-5 ,A135
; expect: line X15 Z-5 F200
,A180
X25 Z-25 ,A150
; expect: line X15 Z-7.679491924 F200
; expect: line X25 Z-25 F200
M30
; expect: end and rewind
