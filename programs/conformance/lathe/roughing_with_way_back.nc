(dialect haas A)
; channel lathe
; A contour that ends with a rapid to where it began, as Haas programs have it: the rapid is none of
; the contour.
G98 G0 X40. Z2. F100
; expect: rapid X20 Z2
G71 P10 Q20 D5. U0 W0
; expect: rapid X15
; expect: line Z-10 F100
; expect: line X16 Z-9 F100
; expect: rapid Z2
; expect: rapid X10
; expect: line Z-10 F100
; expect: line X20 F100
; expect: rapid Z2
N10 G0 X20.
G1 Z-10.
X40.
N20 G0 Z2.
M30
; expect: end and rewind
