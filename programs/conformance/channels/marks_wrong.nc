mark_wait (200, 2);
; expect error 1:12 E6023
mark_wait_soft (1, 9);
; expect error 3:20 E6001
mark_set (1.5);
; expect error 5:11 E6023
M30
