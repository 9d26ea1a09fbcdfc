; G26 S limits the speed of G96, as G50 S and G92 S do on a lathe, and is never a speed.
G26 S2500
G96 S180 M3
; expect: cutting speed 180 limit 2500
; expect: spindle clockwise 0 at cutting speed 180
G26 S1200
; expect: cutting speed 180 limit 1200
G97 S800
; expect: cutting speed off
; expect: spindle speed 800
M30
; expect: spindle stop 0 $-1
; expect: end and rewind
