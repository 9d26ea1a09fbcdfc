; Loops and branches that are still open where the braces around them close.
num count = 0;
while (count < 2) {
  count++;
  WHILE [#1 LT 3] DO1
    #1=[#1+1]
}
if (count > 0) {
  IF [#1 EQ 3] THEN
    X1
}
switch (count) { case 1: { WHILE [1 EQ 1] DO2 } }
if (count > 0) {
  O1 while [1]
    X2
}
M30
; expect error 5:3 E2013
; expect error 9:3 E2013
; expect error 12:28 E2013
; expect error 14:3 E2013
