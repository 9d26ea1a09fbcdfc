; No overloads, no functions in functions, no missing return, no value of void.
num twice (num aa) { return 2*aa; }
num twice (num aa, num bb) { return aa + bb; }
; expect error 3:5 E3002
num maybe (num aa) { if (aa > 0) { return 1; } else if (aa < 0) { return 2; } }
; expect error 5:5 E3012
void nothing () { }
G0 X=nothing ()
; expect error 8:6 E3004
X=twice (1, 2)
; expect error 10:3 E3005
X=twice ("a")
; expect error 12:10 E3004
M30
