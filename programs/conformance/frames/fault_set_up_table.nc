; There is no table of set-up errors.
G54.4 P1
; expect error 2:7 E4016
M30
