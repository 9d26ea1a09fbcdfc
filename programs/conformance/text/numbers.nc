; Values are correctly rounded and ends are what was programmed.
G0 X33.3 Y0.1 Z00012.50
; expect: rapid X33.3 Y0.1 Z12.5
X.3 Y-.5 Z+7.
; expect: rapid X0.3 Y-0.5 Z7
M30
; expect: end and rewind
