; The right side of a combined assignment is computed first; ++ and -- are statements; names have no case.
num depth = 10, list[3] = {1, 2, 3};
depth -= 1 + 2;
depth *= 2 + 1;
G0 X=depth
; expect: rapid X21
depth /= 2 + 1;
DEPTH++;
list[depth - 7] += 5;
list[2]--;
X=depth Y=list[1] Z=list[2]
; expect: rapid X8 Y7 Z2
string text = "a";
text += "b" + str (1 + 1);
msg (text);
; expect: message ab2
num unset;
bool claim;
string empty;
X=unset Y=len (empty) Z=claim ? 1 : 0
; expect: rapid X0 Y0 Z0
M30
; expect: end and rewind
