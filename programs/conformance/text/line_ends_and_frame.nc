%% mixed line ends and comments
(a comment) G0 X1 (another); expect: rapid X1
/* over
lines */ G0 X2 // rest
; expect: rapid X2
  x 3 y-.5 z+4.
; expect: rapid X3 Y-0.5 Z4
N10.5 M30
; expect: end and rewind
%%
not read (((
