(dialect fanuc)
; Order of operations and functions (B-63944EN, 16.2 and 16.4): AND binds like *, OR and XOR like +.
#1=6 AND 3
X#1
; expect: rapid X2
#1=1 OR 6 AND 3
X#1
; expect: rapid X3
#1=5 XOR 1
X#1
; expect: rapid X4
#1=-7 MOD 3
X#1
; expect: rapid X-1
#1=FIX[-1.2]
X#1 Y[FUP[-1.2]]
; expect: rapid X-1 Y-2
#1=FUP[1.2]
#2=FIX[1.8]
X#1 Y#2
; expect: rapid X2 Y1
#1=ATAN[-1]/[-1]
X#1
; expect: rapid X225
#1=ATAN[1]
X#1
; expect: rapid X45
; B-64304EN, 16.3: two values parted by a comma.
#2=ATAN[-1, -1]
#3=[AT[1,0]+POW[2,3]]
X#2 Y#3 Z[POW[#1-43,-1]]
; expect: rapid X225 Y98 Z0.5
#1=ASIN[-0.5]
X#1
; expect: rapid X330
#1=BIN[18] + BCD[12]
X#1
; expect: rapid X30
#1=2
#[#1+1]=SQRT[16]*#1-3
X#3
; expect: rapid X5
IF [[#1 EQ 2] AND [#3 EQ 5]] THEN X6
; expect: rapid X6
#4=#1*COS[#0]-3
X#4
; expect: rapid X-1
M30
; expect: end and rewind
