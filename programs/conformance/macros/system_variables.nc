(dialect fanuc)
; System variables (B-63944EN, 16.2): positions, modal codes, offsets, tools, timers, parts.
G90 G54 G0 X10 Y20 Z30 S500 M3 F150
; expect: spindle speed 500
; expect: spindle clockwise 500
; expect: rapid X10 Y20 Z30
X#5002 Y[#5001+1]
; expect: rapid X20 Y11
X#4001 Y#4003 Z#4109
; expect: rapid X0 Y90 Z150
X[#4014+#4119]
; expect: rapid X554
G81 X1 Z-1 R2
; expect: rapid X1
; expect: rapid Z2
; expect: line Z-1 F150
; expect: rapid Z150
#1=#4009
G80
X#1 Y#4009
; expect: rapid X81 Y80
X#5241 Y#5242
; expect: rapid X100 Y200
#5221=5
; expect: request write offset channel 1 1 5
#1=#2001+#11001
; expect: request read tool channel 5 1
; expect: request read tool channel 1 1
X#1
; expect: rapid X4
#13002=3.5
; expect: request write tool channel 4 2 3.5
#2=2003
#[#2]=0.1
; expect: request write tool channel 5 3 0.1
#1=#5021
; expect: request read pos_mcs
#1=#5041
; expect: request sync
X#1
; expect: rapid X4
#3001=0
; expect: request read clock
X[#3001/1000]
; expect: request read clock
; expect: rapid X0
#1=#1000
; expect: request read in
#1102=1
; expect: output 2 1
#3901=5
X#3901
; expect: rapid X5
#3006=1 (TURN THE PART)
; expect: message TURN THE PART
; expect: program stop
; expect: request sync
#500=7
X#500 Y[#501+1]
; expect: rapid X7 Y1
IF [#501 NE #0] THEN #3000=1 (NOT VACANT)
IF [#500 EQ 7] THEN #3000=21 (LOT NUMBER MISSING)
; expect: request terminate 3021 LOT NUMBER MISSING
; expect error 62:21 U3021
M30
