; GOTO and IF ... GOTO of Fanuc macros (B-63944EN, 16.5.1 and 16.5.2): in every dialect.
#1=0
N10 #1=#1+1
IF [#1 LT 3] GOTO 10
X#1
; expect: rapid X3
IF[#1EQ3]GOTO20
X99
N20 Y#1 (blanks are optional)
; expect: rapid Y3
GOTO [#1 * 10 + 10]
Y99
N40 Z1
; expect: rapid Z1
/N45 GOTO 60
#2=60
GOTO#2
Z99
N60 IF [#1 EQ 3] THEN #1=7
IF [#1 EQ 3] THEN Z98
IF [#1 EQ 7] THEN G1 Z#1 F100
; expect: line Z7 F100
IF [#1 LT 5] THEN
  X1
ELSE
  X2
; expect: line X2 F100
ENDIF
M98 P100
; expect: line Y1 F100
; expect: line Y2 F100
X96
N90 X5
; expect: line X5 F100
GOTO 70
X97
N70 M30
; expect: end and rewind
O100 (numbers of another program are others)
N60 Y1
GOTO 80
Y99
N80 Y2
M99 P90
Y98
M99
