; channel letters
; E and V stand for dS and dl: no `=`, any value, in subprograms and loops.
G1 X10 S_n=60 E0.1 V.05
; expect: law linear S_n=60 dS=0.1 dl=0.05 for the block
; expect: line X10 F60
#1=0.2
X20 S_n=60 E#1 V[#1/2]
; expect: law linear S_n=60 dS=0.2 dl=0.1 for the block
; expect: line X20 F60
void pass (num feed, num step) {
  G1 X30 S_n=feed E=step V=-step
}
pass (50, 0.5);
; expect: law linear S_n=50 dS=-0.5 dl=0.5 for the block
; expect: line X30 F50
for (num turn = 1; turn < 3; turn++) {
  X=30+turn S_n=10*turn E=turn V1
}
; expect: law linear S_n=10 dS=1 dl=1 for the block
; expect: line X31 F10
; expect: law linear S_n=20 dS=2 dl=1 for the block
; expect: line X32 F20
M68 E3 Q5//a code that takes E itself
; expect: analog output 3 5
S_n=60 E0.15 V1
; expect error 25:8 E4336
M30
