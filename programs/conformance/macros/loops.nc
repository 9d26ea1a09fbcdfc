; WHILE ... DO m ... END m of Fanuc macros (B-63944EN, 16.5.3): in every dialect.
#1=1
WHILE [#1 LE 2] DO 1
  #2=#1*10
  WHILE[#2GT0]DO2
    X#2
    #2=#2-10
    IF [#2 EQ 10] GOTO 10
  N10 END2
  #1=#1+1
END 1
; expect: rapid X10
; expect: rapid X20
; expect: rapid X10
DO 3
  #1=#1-1
  IF [#1 LT 0] GOTO 20
  Y#1
END3
; expect: rapid Y2
; expect: rapid Y1
; expect: rapid Y0
N20 M30
; expect: end and rewind
