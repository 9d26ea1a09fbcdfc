(dialect linuxcnc)
; A comment may stand between any two words, also of an expression.
#1=[1 (one) + (and) 2 (two)]
G0 X#1 Y[2 (a) * 3 (b)]
; expect: rapid X3 Y6
X[(first) ATAN[1 (y)]/[1 (x)]]
; expect: rapid X45
M2
; expect: end
