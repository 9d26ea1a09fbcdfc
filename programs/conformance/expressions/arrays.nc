; Two dimensions row by row, an index within 1e-9 of a whole number, a list shorter than its array.
num grid[2][3];
num row, column;
for (row = 0; row < 2; row++) {
  for (column = 0; column < 3; column++) { grid[row][column] = 10*row + column; }
}
G0 X=grid[1][0] Y=grid[0][2] Z=grid[1][2]
; expect: rapid X10 Y2 Z12
num first[] = {5, 6};
num short_[3] = {7};
X=first[0.9999999999] Y=short_[0] Z=short_[2]
; expect: rapid X6 Y7 Z0
string names[2] = {"left", "right"};
bool flags[2];
flags[1] = true;
msg (names[1] + (flags[0] || !flags[1] ? "?" : "!"));
; expect: message right!
X=grid[0][3]
; expect error 18:3 E3011
M30
