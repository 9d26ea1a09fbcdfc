; A variable may hold an axis; it has no value until it is given one.
axis moved = Y;
G0 X3 Y4
; expect: rapid X3 Y4
X=$prog_pos[moved] Y=$prog_pos[X]
; expect: rapid X4 Y3
moved = X;
Z=$prog_pos[moved]
; expect: rapid Z4
msg (moved == X && moved != Y ? "X" : "not X");
; expect: message X
M30
; expect: end and rewind
