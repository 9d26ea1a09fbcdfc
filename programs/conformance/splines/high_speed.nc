; Without axis words G5 P and G5.1 Q are look-ahead switches of other controls: accepted.
G1 X1 F100
; expect: line X1 F100
G5 P10000
X2
; expect: line X2 F100
G5.1 Q1
G5 P0
G5.1 Q0
X3
; expect: line X3 F100
G5.1 Q2
; expect error 12:6 E4008
M30
