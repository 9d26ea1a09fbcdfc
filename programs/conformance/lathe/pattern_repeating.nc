(dialect fanuc A)
; channel lathe
; G73 (B-64304EN-1, 4.2.3) follows the contour R times, U and W less off it from pass to pass; the
; second block has the allowance, U as a diameter.
G98 G0 X50. Z5. F100
; expect: rapid X25 Z5
G73 U4. W2. R3
G73 P10 Q30 U2. W0.5
; expect: rapid X30 Z7.5
; expect: rapid X15
; expect: line Z-7.5 F100
; expect: arc ccw zx centre -12.5,15 X20 Z-12.5 F100
; expect: rapid X28 Z6.5
; expect: rapid X13
; expect: line Z-8.5 F100
; expect: arc ccw zx centre -13.5,13 X18 Z-13.5 F100
; expect: rapid X26 Z5.5
; expect: rapid X11
; expect: line Z-9.5 F100
; expect: arc ccw zx centre -14.5,11 X16 Z-14.5 F100
; expect: rapid X25 Z5
N10 G0 X20.
N20 G1 Z-10.
N30 G3 X30. Z-15. R5.
G0 X2.
; expect: rapid X1
M30
; expect: end and rewind
