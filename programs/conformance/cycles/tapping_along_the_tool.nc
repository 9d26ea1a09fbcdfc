; The tool leans with B by 30 deg: along it G33.1 goes in X and Z, 10 (0.5, 0.866).
S300 M3
; expect: spindle speed 300
; expect: spindle clockwise 300
G0 X20 Z20 B30
; expect: rapid X20 Z20 B30
G33.1 X15 Z11.34 K0.7
; expect: rigid tap X15 Z11.34 lead 0.7
; The other way it would break.
G33.1 X25 Z11.34 K0.7
; expect error 10:1 E4070
M30
