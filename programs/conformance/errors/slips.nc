; Slips of the hand, each with its own answer.
G0 X1O
G0 X10,5
G0 X−5
G0 X#1+5
num depth = 3
num other = 4;
G71 P10 Q20 U1 W0.1
M31
{ G0 X1 ; over
}
M30
; expect error 2:6 E2006
; expect error 3:7 E1002
; expect error 4:5 E1001
; expect error 5:7 E2001
; expect error 6:13 E2001
; expect error 9:1 E4004
; expect error 10:11 E2004
