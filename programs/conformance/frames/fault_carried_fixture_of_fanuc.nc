(dialect fanuc)
; There P is the number of a fixture in a table of its own.
G54.2 P1
; expect error 3:7 E4016
M30
