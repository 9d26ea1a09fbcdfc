(dialect fanuc A)
; channel lathe
; What the code system does not have.
G77 X10. Z-5. F0.1
G91 X1.
G95 G1 X2. F0.1
M30
; expect error 4:1 E4004
; expect error 5:1 E4004
; expect error 6:1 E4004
