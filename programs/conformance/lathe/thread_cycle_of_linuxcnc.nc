(dialect linuxcnc)
; channel lathe
; "The final position of the tool will be at the end of the 'drive line'" (LinuxCNC, G76).
S300 M3 G0 X20 Z5
; expect: spindle speed 300
; expect: spindle clockwise 300
; expect: rapid X20 Z5
G76 Z-10 P1.5 I-1 J0.3 K0.5 R1 Q0 H0
; expect: rapid X18.7
; expect: thread Z-10 lead 1.5
; expect: rapid X20
; expect: rapid Z5
; expect: rapid X18.5
; expect: thread Z-10 lead 1.5
; expect: rapid X20
G0 X30
; expect: rapid X30
M2
; expect: spindle stop 0 $-1
; expect: end
