; A word that two codes would take is meant for one of them: the other must not run with it.
G4 P2 G2 X10 I5 F100
M30
; expect error 2:4 E4015
