(dialect haas)
; Haas mill operator's manual, G47 P1: as many digits of #599 as there are #, zeros before them; #599
; becomes one more. A number is the first one. P76 is the character L, 06 00 40 on a grid of 4 by 6;
; 7 is 06 46 10 on it, 1 is 15 26 20 and 10 30.
G0 X0 Y0 Z5 F100
; expect: rapid X0 Y0 Z5
G47 P76 X0. Y0. J6. R5. Z-.2
; expect: rapid X0 Y0
; expect: rapid X0 Y6
; expect: line Z-0.2 F100
; expect: line X0 Y0 F100
; expect: line X4 Y0 F100
; expect: rapid Z5
; expect: rapid X6 Y0
#599=7
G47 P1 X0. Y0. J6. R5. Z-.2 (#)
; expect: rapid X0 Y0
; expect: rapid X0 Y6
; expect: line Z-0.2 F100
; expect: line X4 Y6 F100
; expect: line X1 Y0 F100
; expect: rapid Z5
; expect: rapid X6 Y0
#1=#599
G1 X#1
; expect: line X8 F100
G47 P1 X0. Y0. J6. R5. Z-.2 (7)
; expect: rapid X0 Y0
; expect: rapid X0 Y6
; expect: line Z-0.2 F100
; expect: line X4 Y6 F100
; expect: line X1 Y0 F100
; expect: rapid Z5
; expect: rapid X6 Y0
G1 X#599
; expect: line X8 F100
#599=12
G47 P1 J6. R5. Z-.2 (#)
; expect: request terminate 4403 the serial number 12 has more digits than #
; expect error 128:5 U4403
M30
