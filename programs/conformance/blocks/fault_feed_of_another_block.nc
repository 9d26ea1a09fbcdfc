; A time belongs to one way only.
G93 G1 X1 F2
; expect: line X1 F2 inverse time
X2
M30
; expect error 4:1 E4023
