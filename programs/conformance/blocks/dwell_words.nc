; X, U and F beside G4 are its time in seconds, and neither an axis, an increment nor a feed.
G1 X1 F100
; expect: line X1 F100
G4 F2
; expect: dwell 2
G4 U3
; expect: dwell 3
G91 G4 X4
; expect: dwell 4
X1
; expect: line X2 F100
G4 P1 F50
; expect: dwell 1
X1
; expect: line X3 F50
M30
; expect: end and rewind
