; Under G43.4 the work offset turns with the table by itself.
G54.2 P1
G43.4 H2
; expect error 3:1 E4301
M30
