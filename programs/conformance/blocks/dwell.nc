; Seconds in P, X, U or F, or revolutions in S.
G4 P1.5
; expect: dwell 1.5
G4 X2
; expect: dwell 2
S600
; expect: spindle speed 600
G4 S10
; expect: dwell 1
G4 P100.
; expect: dwell 100
G4 P200
; expect: dwell 200
; expect warning W410
M30
; expect: end and rewind
