; Behind its braces a name is unknown; inside others it cannot be declared again.
{ num count; }
count = 1;
; expect error 3:1 E3001
num outer;
if (true) { num outer; }
; expect error 6:17 E3002
void change (num outer) { }
; expect error 8:18 E3002
for (num idx = 0; idx < 1; idx++) { }
idx = 1;
; expect error 11:1 E3001
M30
