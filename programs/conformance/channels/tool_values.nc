; The values of a tool by name and by number; the first seven are lengths in program units.
G20
num found = 0;
found = gettable_tool (1, 1, "length") + gettable_tool (1, 1, 1);
; expect: request read tool channel 1 1
; expect: request read tool channel 1 1
settable_tool (2, 1, "length_y", 1);
; expect: request write tool channel 2 2 25.4
settable_tool (2, 1, 3, 1);
; expect: request write tool channel 3 2 25.4
settable_tool (2, 1, "length_x", 1);
; expect: request write tool channel 3 2 25.4
settable_tool (2, 1, "radius", 1);
; expect: request write tool channel 4 2 25.4
settable_tool (2, 1, "wear_length", 0.05);
; expect: request write tool channel 5 2 1.27
settable_tool (2, 1, "wear_radius", 0.05);
; expect: request write tool channel 6 2 1.27
settable_tool (2, 1, "overhang", 1);
; expect: request write tool channel 7 2 25.4
settable_tool (2, 1, "orientation", 1);
; expect: request write tool channel 8 2 1
settable_tool (2, 1, "Angle_Front", 1);
; expect: request write tool channel 9 2 1
settable_tool (2, 1, 10, 1);
; expect: request write tool channel 10 2 1
M30
; expect: end and rewind
