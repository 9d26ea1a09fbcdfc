(dialect fanuc A)
; channel lathe
; Comments may stand before the first line with %, also the one that names the dialect.

%
O1000 (PART)
#1=10*2
G0 X#1
; expect: rapid X10 per revolution
G0 U5
; expect: rapid X12.5 per revolution
M30
; expect: end and rewind
%
not read (((
