; Every function of brackets, in degrees; rounding goes away from zero, FIX down, FUP up.
G0 X[ABS[-2] + SQRT[9]] Y[ACOS[0] + ASIN[1]] Z[ATAN[-1]/[-1]]
; expect: rapid X5 Y180 Z-135
X[COS[60]] Y[EXP[LN[5]]] Z[TAN[45]]
; expect: rapid X0.5 Y5 Z1
X[ROUND[2.5]] Y[ROUND[-2.5]] Z[FIX[2.8]]
; expect: rapid X3 Y-3 Z2
X[FIX[-2.8]] Y[FUP[2.2]] Z[FUP[-2.8]]
; expect: rapid X-3 Y3 Z-2
Xsin[30] Y-#<_motion_mode> Z[2 EQ 2 + 1]
; expect: rapid X0.5 Y0 Z0
X[6 / 2 * 3] Y[2 ** 3 ** 2] Z[- -3]
; expect: rapid X9 Y64 Z3
X[1 AND 0 OR 1] Y[1 OR 1 XOR 1] Z[0 GE -1 AND 3]
; expect: rapid X1 Y0 Z1
M30
; expect: end and rewind
