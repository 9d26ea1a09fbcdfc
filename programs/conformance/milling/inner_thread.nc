; M20 x 2 by tool 1 (radius 1): 9 mm around the middle. 5 mm of thread are 3 turns; the tool comes in and
; goes out by half a circle and half a lead. A left-hand one goes down from above.
#include "mill/threads.nc"
T1 M6 F100
; expect: prepare T1
; expect: change T1
G0 X30 Y40 Z10
; expect: rapid X30 Y40 Z10
mill_inner_thread (20, 2, 0, -5);
; expect: rapid Z-6
; expect: arc ccw xy centre 34.5,40 X39 Y40 Z-5 F100
; expect: arc ccw xy centre 30,40 turns 3 X39 Y40 Z1 F100
; expect: arc ccw xy centre 34.5,40 X30 Y40 Z2 F100
; expect: rapid Z10
mill_inner_thread (20, -2, 0, -5);
; expect: rapid Z2
; expect: arc ccw xy centre 34.5,40 X39 Y40 Z1 F100
; expect: arc ccw xy centre 30,40 turns 3 X39 Y40 Z-5 F100
; expect: arc ccw xy centre 34.5,40 X30 Y40 Z-6 F100
; expect: rapid Z10
mill_inner_thread (20, 2, 0, -5, 2);
; expect: rapid Z-6
; expect: arc ccw xy centre 34.5,40 X39 Y40 Z-5 F100
; expect: arc ccw xy centre 30,40 X39 Y40 Z-3 F100
; expect: arc ccw xy centre 34.5,40 X30 Y40 Z-2 F100
; expect: rapid Z-2
; expect: arc ccw xy centre 34.5,40 X39 Y40 Z-1 F100
; expect: arc ccw xy centre 30,40 X39 Y40 Z1 F100
; expect: arc ccw xy centre 34.5,40 X30 Y40 Z2 F100
; expect: rapid Z10
M30
; expect: end and rewind
