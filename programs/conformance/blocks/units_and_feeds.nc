; G20 and G21 hold for all words of their own block; rotary feeds are deg/min.
G1 X1 F100
; expect: line X1 F100
X2 G20 F10
; expect: line X50.8 F254
X3
; expect: line X76.2 F254
B45
; expect: line B45 F10
G93 G21 X4 F2
; expect: line X4 F2 inverse time
G95 X5 F0.2
; expect: line X5 F0.2 per revolution
M2
; expect: end
