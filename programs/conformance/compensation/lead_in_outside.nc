; A lead-in that meets the contour at an outside corner goes around its start as around all corners,
; not across it; two lines that bend by 10 degrees or less are extended there as well.
T1 M6 G0 Y-5 F100
; expect: prepare T1
; expect: change T1
; expect: rapid Y-5
G41 G1 Y0
; expect: line X-1 Y0 F100
X10
; expect: arc cw xy centre 0,0 X0 Y1 F100
; expect: line X10 Y1 F100
G40 G0 X30 Y-5
; expect: rapid X30 Y-5
G41 G1 X40 Y-4
X50
; expect: line X39.95012438 Y-3 F100
; expect: line X50 Y-3 F100
G40 G0 X60
; expect: rapid X60 Y-4
M30
; expect: end and rewind
