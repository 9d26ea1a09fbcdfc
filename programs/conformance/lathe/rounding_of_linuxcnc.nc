(dialect linuxcnc)
; channel lathe
; A of a line is the radius of a rounding behind it, in profiles and outside of them.
G0 X10 Z0
; expect: rapid X10 Z0
G1 Z-10 A1 F100
X25
; expect: line X10 Z-9 F100
; expect: arc cw zx centre -9,11 X11 Z-10 F100
; expect: line X25 F100
M2
; expect: end
