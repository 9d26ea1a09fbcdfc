; Length moves the programmed point; TCP (RTCP) waits for the axes.
T3 M6 G0 Z100
; expect: prepare T3
; expect: change T3
; expect: rapid Z100
G43
; expect: length H3 0 0 30
G91 Z1
; expect: rapid Z71
G90 G43 H5
; expect: length H5 0 0 50
G43.2 H1
; expect: length H1 0 0 60
G49
; expect: length off
G91 Z0
; expect: rapid Z101
G90 G43.4 H2
; expect: tip H2 0 0 20
; expect: request sync
G53 G0 Z0
; expect error 21:1 E4040
M30
