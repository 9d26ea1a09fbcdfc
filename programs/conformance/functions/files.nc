; A called file shares modal state, R and #, not variables; it returns at its end too.
#include "shares.nc"
num local = 1;
R5=7 #100=8
G90
call ("shares.nc");
; expect: rapid X7 Y8
X1
; expect: rapid X8
X=local Y=R5
; expect: rapid X9 Y17
M30
; expect: end and rewind
