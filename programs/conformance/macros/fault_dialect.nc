(dialect siemens)
M30
; expect error 1:1 E2041
