; A feed per minute is none per revolution.
G1 X1 F100
; expect: line X1 F100
G95 X2
M30
; expect error 4:1 E4020
