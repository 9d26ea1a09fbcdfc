; channel lathe
; Offset 2 of tool 2 is edge 1 of tool 2 here: edge 2 of it is not in the table.
T0202
; expect error 3:1 E5021
M30
