; GV_FRAMES holds rotation, scaling and mirror; restoring them moves nothing.
G68 X0 Y0 R90
; expect: frame 1 X0 Y0 Z0 B0 C0 turned (0 -1 0) (1 0 0) (0 0 1)
G51 X0 Y0 Z0 P2
G51.1 X0
string saved = save_gvector (GV_FRAMES);
G69 G50 G50.1
; expect: frame 1 X0 Y0 Z0 B0 C0
G0 X10 Y4
; expect: rapid X10 Y4
restore_gvector (saved);
; expect: request sync
; expect: frame 1 X0 Y0 Z0 B0 C0 turned (0 -1 0) (1 0 0) (0 0 1)
msg (str ($prog_pos[X]) + " " + str ($prog_pos[Y]));
; expect: message -2 -5
G0 X1 Y1
; expect: rapid X-2 Y2
M30
; expect: end and rewind
