; Without G43.4 nobody finds the angle for the workpiece as it lies.
G54.4 I0.5
; expect: frame 1 X0 Y0 Z0 B0 C0 turned (1 0 0) (0 0.9999619231 -0.008726535498) (0 0.008726535498 0.9999619231)
G0 B20
; expect error 4:1 E4301
M30
