; A setting takes effect behind its block; brackets compute with numbers only.
#3=5 #<size>=2
#3=6 G0 X#3 Y[#3 * #<size>]
; expect: rapid X5 Y10
X#3 Y-#3 Z[#3 MOD 4]
; expect: rapid X6 Y-6 Z2
R1=7
X=R1 Y=R1 - #3 (comment)
; expect: rapid X7 Y1
(DEBUG,#3 is %.1f#3)
; expect: message 6.000000 is 6.0
M30
; expect: end and rewind
