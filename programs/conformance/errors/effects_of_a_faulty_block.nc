; Nothing of a block with an error takes effect; the blocks before are executed.
F100 S200
; expect: spindle speed 200
G1 X5
; expect: line X5 F100
M3 M8 G2 X9 Y0 R1
; expect error 6:16 E4035
M30
