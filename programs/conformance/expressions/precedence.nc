; && before ||, comparisons before equality, ** before a sign, ?: last and from the right.
num two = 2;
bool yes = true, no;
msg (yes || no && no ? "and first" : "or first");
; expect: message and first
msg (1 < two == yes ? "comparison first" : "");
; expect: message comparison first
msg (!no == yes ? "not first" : "");
; expect: message not first
msg (no ? "a" : no ? "b" : "c");
; expect: message c
G0 X=-two ** 2 Y=two ** -1 * 4 Z=two * -two + 1
; expect: rapid X-4 Y2 Z-3
X=7 - two - 1 Y=24 / two / 2 Z=2 * 7 % 4
; expect: rapid X4 Y6 Z2
M30
; expect: end and rewind
