(dialect haas)
; Haas mill operator's manual, G47 P0: the comment is the text, X Y its lower left corner, I its
; direction, J the height of letters, R the level between strokes, Z the depth, F and E the feeds. L is
; 06 00 40 on a grid of 4 by 6.
G0 X0 Y0 Z1 F100
; expect: rapid X0 Y0 Z1
G47 P0 X10. Y20. J6. R5. Z-.2 F300. E50. (L)
; expect: rapid Z5
; expect: rapid X10 Y20
; expect: rapid X10 Y26
; expect: line Z-0.2 F50
; expect: line X10 Y20 F300
; expect: line X14 Y20 F300
; expect: rapid Z5
; expect: rapid X16 Y20
#1=12
G47 P0 I90. J#1 Z-.2 (L)
; expect: rapid X16 Y20
; expect: rapid X4 Y20
; expect: line Z-0.2 F100
; expect: line X16 Y20 F100
; expect: line X16 Y28 F100
; expect: rapid Z5
; expect: rapid X16 Y32
M30
; expect: end and rewind
