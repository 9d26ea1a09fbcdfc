(dialect linuxcnc)
; channel lathe
; P and Q of other controls are no profile.
F100
G71 D1 I1
; expect error 5:1 E4007
M2
