(dialect linuxcnc)
; channel lathe
; No depth of cut.
F100
G0 X30 Z2
; expect: rapid X30 Z2
G71 Q100 I0
; expect error 7:10 E4008
M2
O100 sub
G0 X10 Z0
G1 Z-10
X20 Z-20
X15 Z-25
Z-30
X25 Z-40
O100 endsub
