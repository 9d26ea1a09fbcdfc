; G54.4: the workpiece lies shifted and turned in its work offset. A quarter turn about Z: X of the
; program lies along Y of the offset.
G54.4 X0.5 Y-0.25 K90
; expect: frame 1 X0.5 Y-0.25 Z0 B0 C0 turned (0 -1 0) (1 0 0) (0 0 1)
G0 X10 Y20
; expect: rapid X10 Y20
G52 X1
; expect: frame 1 X0.5 Y0.75 Z0 B0 C0 turned (0 -1 0) (1 0 0) (0 0 1)
G52 X0
; expect: frame 1 X0.5 Y-0.25 Z0 B0 C0 turned (0 -1 0) (1 0 0) (0 0 1)
; Under G43.4 the tool leans as the workpiece lies: towards (sin B cos C, -sin B sin C, cos B), turned
; by a quarter, which is C less 90.
G43.4 H2
; expect: tip H2 0 0 20
; expect: request sync
G0 X1 B30 C100
; expect: rapid X1 B30 C10
G91 G1 C20 F600
; expect: line B30 C30 F600
G90 G54.4 P0
; expect: frame 1 X0 Y0 Z0 B0 C0
G49
; expect: length off
; expect: request sync
M30
; expect: end and rewind
