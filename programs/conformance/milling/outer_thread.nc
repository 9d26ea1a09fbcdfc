; A core of 16 mm by tool 1 (radius 1): 9 mm around the middle, clockwise and down for a right-hand
; thread.
#include "mill/threads.nc"
T1 M6 F100
; expect: prepare T1
; expect: change T1
G0 X0 Y0 Z10
; expect: rapid X0 Y0 Z10
mill_outer_thread (16, 2, 0, -4);
; expect: rapid X10
; expect: rapid Z0
; expect: arc ccw xy centre 9.5,0 X9 Y0 F100
; expect: arc cw xy centre 0,0 turns 2 X9 Y0 Z-4 F100
; expect: arc ccw xy centre 9.5,0 X10 Y0 F100
; expect: rapid Z10
; expect: rapid X0
M30
; expect: end and rewind
