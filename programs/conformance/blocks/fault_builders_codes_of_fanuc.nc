(dialect fanuc)
; M codes that only LinuxCNC has are the builder's on Fanuc and Haas controls (operator's manuals: lists of M
; codes): without a meaning in the machine file they have none, and never that of LinuxCNC.
M50
; expect error 4:1 E4004
N1 M53 P0
; expect error 6:4 E4004
M66 P1 L3 Q1
; expect error 8:1 E4004
X1 M70
; expect error 10:4 E4004
M30
