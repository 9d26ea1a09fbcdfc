; channel lathe
; G50 S limits the speed of G96, as G92 S does, and is never a speed.
G50 S1500
G96 S180 M3
; expect: cutting speed 180 limit 1500
; expect: spindle clockwise 0 at cutting speed 180
G50 S1200
; expect: cutting speed 180 limit 1200
G97 S800
; expect: cutting speed off
; expect: spindle speed 800
G50 S1000
M30
; expect: spindle stop 0 $-1
; expect: end and rewind
