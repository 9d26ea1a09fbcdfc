%
O1234 (FLANGE)
(Sources: Fanuc B-63944EN, 12 and 13; what CAM systems write for its machining centres.)
N10 G21
; channel mill
N20 G90 G17 G40 G49 G80
N30 T1 M6
; expect: prepare T1
; expect: change T1
N40 G90 G54 G0 X0 Y0 S1500 M3
; expect: spindle speed 1500
; expect: spindle clockwise 1500
; expect: rapid X0 Y0
N50 G43 H1 Z50. M8
; expect: coolant flood
; expect: length H1 0 0 10
; expect: rapid Z50
N60 G98 G83 X10. Y5. Z-5. R2. Q4. F180.
; expect: rapid X10 Y5
; expect: rapid Z2
; expect: line Z-2 F180
; expect: rapid Z2
; expect: rapid Z-1.746
; expect: line Z-5 F180
; expect: rapid Z50
N70 G80 M9
; expect: coolant off
N80 G91 G28 Z0.
; expect: rapid Z50
; expect: rapid Z0 machine
N90 M30
; expect: spindle stop 0 $-1
; expect: end and rewind
%
