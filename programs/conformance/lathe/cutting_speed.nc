; channel lathe
; S of G96 and of the blocks after it is a cutting speed, in G20 in ft/min; G92 S and D limit the
; spindle.
G96 S180 D2500 M3
; expect: cutting speed 180 limit 2500
; expect: spindle clockwise 0 at cutting speed 180
S200
; expect: cutting speed 200 limit 2500
G20 G96 S1000
; expect: cutting speed 304.8 limit 2500
G92 S1500
; expect: cutting speed 304.8 limit 1500
G21 G97 S800
; expect: cutting speed off
; expect: spindle speed 800
S900
; expect: spindle speed 900
M30
; expect: spindle stop 0 $-1
; expect: end and rewind
