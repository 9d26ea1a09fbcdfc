(dialect linuxcnc)
; channel lathe
; The tool stands between the ends of the profile.
F100
G0 X15 Z2
; expect: rapid X15 Z2
G71 Q100 I1
; expect error 7:1 E4068
M2
O100 sub
G0 X10 Z0
G1 Z-10
X20 Z-20
X15 Z-25
Z-30
X25 Z-40
O100 endsub
