; All errors of a file are found at once.
G0 X1 X2
; expect error 2:7 E4001
G0 G1 X1
; expect error 4:4 E4002
G0 X1 Q5
; expect error 6:7 E4003
G99.9
; expect error 8:1 E4004
G52 X1 G92 Y1
; expect error 10:8 E4006
G43.1
; expect error 12:1 E4007
num aa = "text";
; expect error 14:10 E3004
aa = ;
; expect error 16:6 E2001
bb = 1;
; expect error 18:1 E3001
if (1) { }
; expect error 20:5 E3006
#kinematiks (1, 1)
; expect error 22:1 E2010
G34 X1
; expect error 24:1 E2090
M30
