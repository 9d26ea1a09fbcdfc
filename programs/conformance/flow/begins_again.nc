; M99 in the main program begins it again in the modal state it left; variables are new, parameters stay.
num pass = 1;
#100=[#100+1]
F=100*#100
G1 X=10*pass
pass += 1;
G91
M99
; expect: line X10 F100
; expect: request program restart
; expect: line X20 F200
; expect: request program restart
; expect: restart
