; G80 cannot end a sequence of cycles and begin another in one block.
G0 Z20 F50
G80 G81 X10 Z-5 R2
; expect error 3:5 E4002
M30
