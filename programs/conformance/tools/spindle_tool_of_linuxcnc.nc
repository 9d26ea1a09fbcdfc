(dialect linuxcnc)
; H0 and D0 name the tool in the spindle (interp_find.cc, find_tool_index; so does rs274 2.9).
T3 M6 G43 H0
; expect: prepare T3
; expect: change T3
; expect: length H3 0 0 30
G0 X1
; expect: rapid X1
F100 G41 D0 G1 X5
X20
; expect: line X5 Y1 F100
G40
; expect: line X20 Y1 F100
M2
; expect: end
