(dialect haas)
; expect error 5:1 E4061
G0 X0 Y0
; expect: rapid X0 Y0
G70 I10 L4
M30
