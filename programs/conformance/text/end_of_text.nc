; A program without an end ends like M30, with a warning.
G0 X1
; expect: rapid X1
; expect: end of text
; expect warning W211
