; == of numbers is exact, near() and EQ are not; strings compare with their case.
num sum = 0.1 + 0.2;
bool found;
msg (sum == 0.3 ? "equal" : "not equal");
; expect: message not equal
msg (near (sum, 0.3) ? "near" : "far");
; expect: message near
msg (near (1, 1.001) || near (1, 1.5, 0.4) ? "near" : "far");
; expect: message far
#1=0.3000001
G0 X[#1 EQ 0.3] Y[#1 NE 0.3] Z[#1 GT 0.3]
; expect: rapid X1 Y0 Z1
found = "Part" == "PART";
msg (found ? "same" : "other");
; expect: message other
found = "a" + "b" == "ab" && "" != "x";
msg (found ? "same" : "other");
; expect: message same
M30
; expect: end and rewind
