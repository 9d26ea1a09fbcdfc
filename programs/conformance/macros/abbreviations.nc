(dialect fanuc)
; Fanuc B-63944EN, 16.8: two letters stand for a word of a macro. A `/` behind the block number leaves
; the rest of the block out where the switch is on.
#1=0 F100
WH[#1LT2]DO1
#1=#1+1
IF[#1EQ2]TH X#1
; expect: rapid X2
EN1
#2=SQ[16]+AB[-1]+SI[30]+FI[1.9]+FU[0.1]
X#2
; expect: rapid X7.5
IF[[#1EQ2]AN[#2GT7]]GO20
X99
N20 / X3
; expect: rapid X3
GO30
X98
N30 M30
; expect: end and rewind
