; An axis variable must be initialised, and is no number.
axis moved;
; expect error 2:6 E3007
axis other = X;
num sum = other + 1;
; expect error 5:11 E3004
M30
