; Each use of a shared variable asks the machine, in the order of the text; answers are 2 here.
shared num part_count, table_row[3][4];
part_count = part_count + 1;
; expect: request read shared part_count[0]
; expect: request write shared part_count[0] 3
; What combines is one request, between whose reading and writing nobody comes.
part_count++;
; expect: request combine shared part_count[0] + 1
part_count -= 3;
; expect: request combine shared part_count[0] - 3
part_count *= part_count;
; expect: request read shared part_count[0]
; expect: request combine shared part_count[0] * 2
part_count /= 4;
; expect: request combine shared part_count[0] / 4
table_row[1][2] += 5;
; expect: request combine shared table_row[6] + 5
if (table_row[2][3] > 1) { msg ("on"); }
; expect: request read shared table_row[11]
; expect: message on
M30
; expect: end and rewind
