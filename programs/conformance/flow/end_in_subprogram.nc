; M30 in a called subprogram ends the whole program, in a function too.
void finish () {
  M30
}
M98 P7
G0 X99
M30
O7
G0 X1
; expect: rapid X1
finish ();
; expect: end and rewind
M99
