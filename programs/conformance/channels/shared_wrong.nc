shared num counted = 5;
; expect error 1:12 E3020
shared axis lane;
; expect error 3:13 E3020
num size = 3;
shared num rows[size];
; expect error 6:12 E3020
if (true) { shared num inner; }
; expect error 8:24 E3020
M30
