(dialect fanuc A)
; channel lathe
; R of the first block of G76 has a point on Fanuc controls: R200 is no last cut of 0.2 mm.
G76 P020060 Q100 R200
; expect error 4:18 E4016
M30
