; A computed number is looked for when the jump is made.
#1=7
GOTO #1
; expect error 3:6 E3024
M30
