; G54 to G59.3 and the extended table are offsets 1 to 9 and 10 upwards; only the second one is not 0.
G0 X1
; expect: rapid X1
G55
; expect: frame 2 X100 Y200 Z300 B0 C0
G54
; expect: frame 1 X0 Y0 Z0 B0 C0
G56
; expect: frame 3 X0 Y0 Z0 B0 C0
G57
; expect: frame 4 X0 Y0 Z0 B0 C0
G58
; expect: frame 5 X0 Y0 Z0 B0 C0
G59
; expect: frame 6 X0 Y0 Z0 B0 C0
G59.1
; expect: frame 7 X0 Y0 Z0 B0 C0
G59.2
; expect: frame 8 X0 Y0 Z0 B0 C0
G59.3
; expect: frame 9 X0 Y0 Z0 B0 C0
G54.1 P7
; expect: frame 16 X0 Y0 Z0 B0 C0
M30
; expect: end and rewind
