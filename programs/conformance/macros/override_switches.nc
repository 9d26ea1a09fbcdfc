(dialect fanuc)
; Fanuc B-63944EN, 16.2, #3003 and #3004: bit 0 of #3004 lets a feed hold wait, bit 1 keeps the feed
; override from acting. #3003, single block, changes nothing here.
#3003=1
#3004=3
; expect: spindle override only no feed stop
#1=#3004
X#1
; expect: rapid X3
#3004=0
; expect: overrides on
#3003=0
G43 H2
; expect: length H2 0 0 20
#2=#5083
X#2
; expect: rapid X20
M30
; expect: end and rewind
