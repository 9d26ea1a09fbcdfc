(dialect haas)
; Haas mill operator's manual: R of a drilling cycle may be left out; the tool goes from where it
; stands.
G0 X0 Y0 Z10 F100
; expect: rapid X0 Y0 Z10
G81 Z-5
; expect: line Z-5 F100
; expect: rapid Z10
X20
; expect: rapid X20
; expect: line Z-5 F100
; expect: rapid Z10
G82 R2 P100 X30
; expect: rapid X30
; expect: rapid Z2
; expect: line Z-5 F100
; expect: dwell 0.1
; expect: rapid Z10
G80
M30
; expect: end and rewind
