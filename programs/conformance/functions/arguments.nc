; From left to right, by value but for & and arrays; default values at the end; a value may be left unused.
num order;
num next_of (num base) { order = 10*order + base; return base; }
num three (num aa, num bb = 20, num cc = 30) { aa += 1; return aa + bb + cc; }
void fill (num list[], num &last) { list[0] = 5; last += 1; list[1] = last; }
num value = three (next_of (1), next_of (2), next_of (3));
G0 X=order Y=value
; expect: rapid X123 Y7
X=three (1) Y=three (1, 2)
; expect: rapid X52 Y34
num one = 1, pair[2];
three (one);
X=one
; expect: rapid X1
fill (pair, one);
fill (pair, pair[0]);
X=pair[0] Y=pair[1] Z=one
; expect: rapid X6 Y6 Z2
M30
; expect: end and rewind
