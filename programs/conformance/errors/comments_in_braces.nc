; Comments as other controls write them.
{ this is a comment }
{Roughing}
G0 X1 {next to it}
{ G0 X2 }
; expect error 2:1 E2001
; expect error 3:1 E2001
; expect error 4:7 E2001
M30
