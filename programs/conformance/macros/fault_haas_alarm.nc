(dialect haas)
; #3000 adds 1000 there, 3000 on Fanuc controls.
IF [#1 EQ #0] THEN #3000=15 (NO DIAMETER)
M30
; expect: request terminate 1015 NO DIAMETER
; expect error 3:20 U1015
