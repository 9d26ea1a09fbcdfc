(dialect linuxcnc)
; channel lathe
; G71 roughs the profile of a subprogram up to D across it, in levels of I from the start point, and
; follows its parallel: intersections inside, arcs outside. G70 follows it at 0.2 and on itself.
O100 sub
G0 X10 Z0
G1 Z-10
X20 Z-20
Z-30
X25
O100 endsub
F100
G0 X30 Z2
; expect: rapid X30 Z2
G71 Q100 D0.5 I6 R0.5
; expect: rapid X24
; expect: line Z-29.5 F100
; expect: line X24.5 Z-29 F100
; expect: rapid Z2
; expect: rapid X18
; expect: line Z-17.29289322 F100
; expect: line X18.5 Z-16.79289322 F100
; expect: rapid Z2
; expect: rapid X12
; expect: line Z-11.29289322 F100
; expect: line X12.5 Z-10.79289322 F100
; expect: rapid Z2
; expect: rapid X10.5
; expect: line Z0 F100
; expect: line Z-9.792893219 F100
; expect: line X20.35355339 Z-19.64644661 F100
; expect: arc ccw zx centre -20,20 X20.5 Z-20 F100
; expect: line Z-29.5 F100
; expect: line X25 F100
; expect: line X30 F100
G70 Q100 X32 Z3 D0.4 P2
; expect: rapid X32 Z3
; expect: rapid Z0
; expect: rapid X10.2
; expect: line Z-9.917157288 F100
; expect: line X20.14142136 Z-19.85857864 F100
; expect: arc ccw zx centre -20,20 X20.2 Z-20 F100
; expect: line Z-29.8 F100
; expect: line X25 F100
; expect: rapid X32 Z3
; expect: rapid Z0
; expect: rapid X10
; expect: line Z-10 F100
; expect: line X20 Z-20 F100
; expect: line Z-30 F100
; expect: line X25 F100
M2
; expect: end
