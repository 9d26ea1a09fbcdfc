; Settings take effect after all values of their block are known, and before what it calls; of two
; settings of one parameter the last holds.
#1=1 #1=2
G0 X#1
; expect: rapid X2
#1=5 M98 P100 
; expect: rapid Y5
#1=6 G0 X#1 #1=7
; expect: rapid X5
X#1
; expect: rapid X7
#2=1
##2=9 #[#2 + 1]=4
X#1 Y#2
; expect: rapid X9 Y4
X[2 + 3 * 2 ** 2 ** 1] Y[-2 ** 2] Z[7 - 2 - 1]
; expect: rapid X14 Y4 Z4
X[5 MOD 3] Y[-5 MOD 3] Z[5 MOD -3]
; expect: rapid X2 Y1 Z2
X[1 EQ 1.0000001] Y[1 LT 1.0000001] Z[1 NE 1.00001]
; expect: rapid X1 Y1 Z1
X[1 OR 0 AND 0] Y[2 XOR 3] Z[1 + 1 EQ 2]
; expect: rapid X0 Y0 Z1
X[ATAN[1] / [-1]] Y[ROUND[-2.5]] Z[FUP[-1.5] + FIX[-1.5]]
; expect: rapid X135 Y-3 Z-3
M30
; expect: end and rewind
O100
G0 Y#1
M99
