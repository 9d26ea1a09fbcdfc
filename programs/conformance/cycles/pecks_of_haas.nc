(dialect haas)
; Haas mill operator's manual, G83 and G73: I is the first peck, each next one is J less, down to K;
; K beside Q of G73 is the depth after which it goes back to R. Both stay 0.254 mm off the last depth.
G0 X0 Y0 Z5 F100
; expect: rapid X0 Y0 Z5
G83 G99 Z-10 R0 I4 J1 K2 X1
; expect: rapid X1
; expect: rapid Z0
; expect: line Z-4 F100
; expect: rapid Z0
; expect: rapid Z-3.746
; expect: line Z-7 F100
; expect: rapid Z0
; expect: rapid Z-6.746
; expect: line Z-9 F100
; expect: rapid Z0
; expect: rapid Z-8.746
; expect: line Z-10 F100
; expect: rapid Z0
G80
G73 Z-6 R0 Q2 K4 X2
; expect: rapid X2
; expect: line Z-2 F100
; expect: rapid Z-1.746
; expect: line Z-4 F100
; expect: rapid Z0
; expect: rapid Z-3.746
; expect: line Z-6 F100
; expect: rapid Z0
G80
M30
; expect: end and rewind
