; The alarm of the cycle itself: the tool (radius 1) does not fit into a thread of 2 mm.
#include "mill/threads.nc"
T1 M6 F100
; expect: prepare T1
; expect: change T1
mill_inner_thread (2, 0.4, 0, -5);
; expect error 8:38 U4401
; expect: request terminate 4401 the tool does not fit into the thread
M30
