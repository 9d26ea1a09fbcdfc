; `continue` of a `for` does its step; every part of a `for` may be missing; `do` runs once at least.
num idx, turns;
for (idx = 0; idx < 4; idx += 1) {
  if (idx == 1) { continue; }
  turns += 1;
}
G0 X=idx Y=turns
; expect: rapid X4 Y3
for (;;) {
  idx -= 1;
  if (idx < 2) { break; }
}
X=idx
; expect: rapid X1
do { idx = 50; } while (false);
while (false) { idx = 60; }
X=idx
; expect: rapid X50
for (idx = 0; idx < 3; idx++) {
  for (num inner = 0; inner < 9; inner++) {
    if (inner == 1) { break; }
    Y=10*idx + inner
  }
}
; expect: rapid Y0
; expect: rapid Y10
; expect: rapid Y20
M30
; expect: end and rewind
