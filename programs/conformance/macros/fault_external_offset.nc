(dialect fanuc)
; P0 is the offset of all systems on Fanuc controls, the active system on LinuxCNC.
G10 L2 P0 X1
M30
; expect error 3:8 E5001
