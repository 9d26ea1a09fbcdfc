; channel two spindles
; Each spindle has its own speed; all of them are started one by one where the speeds differ.
S1500 $2 M3
; expect: spindle speed 1500 $2
; expect: spindle clockwise 1500 $2
S2=900
; expect: spindle speed 900 $2
S500 M4
; expect: spindle speed 500
; expect: spindle counter-clockwise 500
M3 $-1
; expect: spindle clockwise 500 $1
; expect: spindle clockwise 900 $2
G4 S3 $2
; expect: dwell 0.2
M5
; expect: spindle stop 500
M19 R30 P1 Q2 $2
; expect: spindle orient 900 $2 R30 clockwise within 2
M3 $3
; expect error 20:1 E4053
M30
