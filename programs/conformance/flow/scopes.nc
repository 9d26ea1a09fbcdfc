; A variable lives in its braces, anew in every pass; the name is free again behind them.
num turn;
while (turn < 2) {
  num count;
  count += 1;
  G0 X=count
  turn += 1;
}
; expect: rapid X1
; expect: rapid X1
{ num count = 5;
  Y=count }
; expect: rapid Y5
for (num idx = 2; idx > 0; idx -= 1) { Z=idx }
; expect: rapid Z2
; expect: rapid Z1
for (num idx = 7; idx < 8; idx++) { Z=idx }
; expect: rapid Z7
M30
; expect: end and rewind
