; M62, M63, M67 wait for the next motion, M64, M65, M68 do not; M66 asks and leaves #5399.
M62 P3
; expect: output 3 1 with motion
M63 P3 G1 X10 F100
; expect: output 3 0 with motion
; expect: line X10 F100
M64 P0
; expect: output 0 1
M65 P63
; expect: output 63 0
M67 E2 Q1.5
; expect: analog output 2 1.5 with motion
M68 E15 Q-2
; expect: analog output 15 -2
M66 P4 L3 Q0.5
; expect: request wait for input 4 mode 3 timeout 0.5
G0 X#5399
; expect: rapid X2
M30
; expect: end and rewind
