; Partners include the own channel; mark_clear is a sync point, the others travel with the path.
G1 X10 F100
; expect: line X10 F100
mark_set (5);
; expect: mark set 5 1
mark_wait_soft (3, 2);
; expect: mark wait soft 3 1 2
mark_wait (199, 2, 1);
; expect: request mark wait 199 with 1 with 2
mark_clear (5);
; expect: mark clear 5 1
; expect: request sync
if (mark_is_set (2, 7)) { msg ("set"); }
; expect: request mark state channel 2 7
; expect: message set
M30
; expect: end and rewind
