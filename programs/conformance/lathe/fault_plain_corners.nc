(dialect fanuc A)
; channel lathe
; Where the machine file does not say that R of G1 is a rounding, it is no word of it.
G1 Z-20 R5 F0.2
M30
; expect error 4:9 E4003
