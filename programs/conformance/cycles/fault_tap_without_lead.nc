; Tapping with neither F nor K.
S500 G84 Z-5 R1
; expect error 2:6 E4066
M30
