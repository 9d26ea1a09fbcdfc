(dialect haas)
; channel lathe
G254
; expect error 3:1 E4004
M30
