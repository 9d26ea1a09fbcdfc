; Blocks in the bodies of loops.
num depth;
while (depth > -2) {
  depth -= 1;
  G1 Z=depth F100
}
; expect: line Z-1 F100
; expect: line Z-2 F100
for (num idx = 0; idx < 3; idx++) {
  if (idx == 1) { continue; }
  G0 X=idx*10
}
; expect: rapid X0
; expect: rapid X20
switch (depth) {
  case -1: { G0 Y1 }
  case -2, -3: { G0 Y2
  M8 }
}
; expect: rapid Y2
; expect: coolant flood
M30
; expect: coolant off
; expect: end and rewind
