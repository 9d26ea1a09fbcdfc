; Values are in program units; what does not exist is told by the machine, not by the load.
settable_zs (1, 2, X, 5);
; expect: request write offset channel 1 2 5
G20
if (settable_tool (3, 1, "radius", 0.5) == false) { M0
}
; expect: request write tool channel 4 3 12.7
num depth = gettable_tool (3, 1, 4);
; expect: request read tool channel 4 3
G0 X=depth * 25.4
; expect: rapid X50.8
M30
; expect: end and rewind
