; A tap goes along one axis: X is where it stands, or the hole is not there. LinuxCNC taps on a
; slant, of which its manual warns (G33.1).
S300 M3
; expect: spindle speed 300
; expect: spindle clockwise 300
G0 X10 Z2
; expect: rapid X10 Z2
G33.1 X10 Z-10 K0.7
; expect: rigid tap X10 Z-10 lead 0.7
G33.1 X20 Z-10 K0.7
; expect error 10:1 E4070
M30
