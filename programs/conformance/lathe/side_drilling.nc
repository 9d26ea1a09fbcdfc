(dialect fanuc A)
; channel lathe
; Drilling with live tools (B-64304EN-1, 5.2): G83 G85 into the face, G87 G89 into the side. R is the
; way from the initial level, Q counts thousandths without a point, without Q the hole is made in one
; go.
G98 G0 X60. Z-10. C0. F50
; expect: rapid X30 Z-10 C0
G87 X40. R-5. Q3000 P500
; expect: rapid X25
; expect: line X22 F50
; expect: rapid X25
; expect: rapid X22.254
; expect: line X20 F50
; expect: dwell 0.5
; expect: rapid X30
C90.
; expect: rapid C90
; expect: rapid X25
; expect: line X22 F50
; expect: rapid X25
; expect: rapid X22.254
; expect: line X20 F50
; expect: dwell 0.5
; expect: rapid X30
G80
G89 X50. R-2. P1000
; expect: rapid X28
; expect: line X25 F50
; expect: dwell 1
; expect: line X28 F50
; expect: rapid X30
G80 G0 X0 Z5.
; expect: rapid X0 Z5
G83 Z-10. R-3.
; expect: rapid Z2
; expect: line Z-10 F50
; expect: rapid Z5
Z-8. P200
; expect: rapid Z2
; expect: line Z-8 F50
; expect: dwell 0.2
; expect: rapid Z5
G80
M30
; expect: end and rewind
