(dialect fanuc)
; A number with a meaning that stanok does not have is an error, never zero.
#1=#3011
; expect error 3:4 E3015
M30
