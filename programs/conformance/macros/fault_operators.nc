(dialect fanuc)
; What looks like another thing than it is.
IF [#1 EQ 0 AND #2 EQ 1] GOTO 10
N10 M30
; expect error 3:20 E2008
