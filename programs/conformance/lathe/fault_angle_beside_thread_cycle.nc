; channel lathe
; Outside of the dialects of Fanuc and Haas G78 has no angle.
S300 M3 G0 X40 Z2
G78 X38 Z-5 F1.5 Q180
; expect error 4:18 E4003
M30
