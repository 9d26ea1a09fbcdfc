; Types of C are named, with the one that stands for them here.
double depth = 1;
; expect error 2:1 E3001
int count;
; expect error 4:1 E3001
for (num turn = 0; turn < 2; turn += 1) {
  float part = 2;
; expect error 7:3 E3001
}
M30
