(dialect haas)
; Variables that Haas numbers otherwise than Fanuc (mill operator's manual, table of the macro
; variables): #10000 and on belong to programs, #100 is #10100, #500 is #10500; #2001 is a length.
#10002=7
#10100=3
#10500=4
G0 X#10002 Y#100 Z#500
; expect: rapid X7 Y3 Z4
#800=5
X#10800
; expect: rapid X5
#1=#2001+#2601
; expect: request read tool channel 1 1
; expect: request read tool channel 6 1
#2402=3
; expect: request write tool channel 4 2 3
#1=#11018
; expect: request read in
#12003=1
; expect: output 3 1
T2 M6
; expect: prepare T2
; expect: change T2
X#3026
; expect: rapid X2
; M99 with a condition; a macro with L has its arguments from the first call only.
G65 P100 A1 L3
; expect: rapid X2
; expect: rapid X3
; expect: rapid X4
#1=0
N10 #1=#1+1
X#1
[#1 LT 3] M99 P10
; expect: rapid X1
; expect: rapid X2
; expect: rapid X3
; THEN may be left out.
IF [#1 EQ 3] X#1 F600
; expect: rapid X3
IF [#1 EQ 4] X9
IF[#1 EQ 3]#1=6
X#1
; expect: rapid X6
; G100 and G101 are the mirror.
G101 X1
X5
; expect: rapid X-3
G100
X5
; expect: rapid X5
M30
; expect: end and rewind
O100
#1=#1+1
X#1
M99
