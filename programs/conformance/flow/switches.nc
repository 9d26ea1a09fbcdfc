; `default` counts only when no case does, wherever it stands; `break` in a case leaves the loop around.
num part = 3;
switch (part) {
  default: { G0 X1 }
  case 1 + 2: { G0 X2 }
}
; expect: rapid X2
switch (part * 2) { case 1: { G0 X3 } }
switch ("Left") {
  case "left": { G0 X4 }
  case "Left", "L": { G0 X5 }
}
; expect: rapid X5
while (true) {
  switch (part) {
    case 5: { break; }
    default: { part += 1; }
  }
  Y=part
}
; expect: rapid Y4
; expect: rapid Y5
X=part
; expect: rapid X5
switch (0.1 + 0.2) {
  case 0.3: { G0 X6 }
  default: { G0 X7 }
}
; expect: rapid X7
M30
; expect: end and rewind
