; Each use of a shared variable asks the machine, in the order of the text; answers are 2 here.
shared num part_count, table_row[3][4];
part_count = part_count + 1;
; expect: request read shared part_count[0]
; expect: request write shared part_count[0] 3
part_count++;
; expect: request read shared part_count[0]
; expect: request write shared part_count[0] 3
table_row[1][2] += 5;
; expect: request read shared table_row[6]
; expect: request write shared table_row[6] 7
if (table_row[2][3] > 1) { msg ("on"); }
; expect: request read shared table_row[11]
; expect: message on
M30
; expect: end and rewind
