(dialect haas)
; #700 to #749 are nobody's there.
#1=#710
M30
; expect error 3:4 E3015
