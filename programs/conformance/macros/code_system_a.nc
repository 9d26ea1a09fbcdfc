(dialect fanuc A)
; channel lathe
; Code system A (B-64304EN-1, table 3.1): G90 G92 G94 are cycles, G98 G99 the feed, U W increments.
G99 G97 S300 M3 G0 X20. Z2. F0.2
; expect: spindle speed 300
; expect: spindle clockwise 300
; expect: rapid X10 Z2 per revolution
G90 X18. Z-10.
; expect: rapid X9 per revolution
; expect: line Z-10 F0.2 per revolution
; expect: line X10 F0.2 per revolution
; expect: rapid Z2 per revolution
U-3.
; expect: rapid X8.5 per revolution
; expect: line Z-10 F0.2 per revolution
; expect: line X10 F0.2 per revolution
; expect: rapid Z2 per revolution
G0 U2. W1.
; expect: rapid X11 Z3 per revolution
G98 G1 W-1. F100.
; expect: line Z2 F100
G50 S2500
G96 S180
; expect: cutting speed 180 limit 2500
G97 S300
; expect: cutting speed off
; expect: spindle speed 300
G92 X20. Z-8. F1.5
; expect: rapid X10
; expect: thread Z-8 lead 1.5
; expect: rapid X11
; expect: rapid Z2
M30
; expect: spindle stop 0 $-1
; expect: end and rewind
