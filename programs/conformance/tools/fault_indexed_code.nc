; An index behind M reads like M2.
M2=3
; expect error 2:1 E2011
M30
