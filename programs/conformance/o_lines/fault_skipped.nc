; Of skipped O-lines all lines are skipped.
/ o2 if [1]
G0 X7
/ o2 endif
; expect error 3:1 E2005
M30
