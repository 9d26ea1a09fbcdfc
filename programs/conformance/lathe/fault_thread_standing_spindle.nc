; channel lathe
; M5 before a thread.
S500 G33 Z-5 F2
; expect error 3:6 E4064
M30
