; A call saves no modal state: what a function leaves in force stays.
void step (num by) {
  G91 G1 X=by F200
}
G90 G0 X10
; expect: rapid X10
step (2);
; expect: line X12 F200
X2
; expect: line X14 F200
step (3);
; expect: line X17 F200
M30
; expect: end and rewind
