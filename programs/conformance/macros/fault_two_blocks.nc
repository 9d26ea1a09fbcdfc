(dialect fanuc)
; `;` ends a block: what stands behind it on the line would be passed over.
G0 X1; G1 Z-5 F100
X2;
X3 ; to the corner
#1=5; #2=6
GOTO 10; X5
N10 M30; (END)
; expect error 3:6 E2004
; expect error 6:5 E2004
; expect error 7:8 E2004
