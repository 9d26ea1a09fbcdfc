(dialect haas)
; Probing macros of Haas controls hold parentheses inside comments: the comment goes on to the one that
; closes the first. Nothing in it is executed.
(#5 = #6998 (STATUS OF PARAMETER 710))
G0 X1 (A (B) G0 X2 ((C)) D)
; expect: rapid X1
M30
; expect: end and rewind
