; The first line names no dialect: of LinuxCNC a comment holds no other one.
G0 X1 (A (B))
; expect error 2:10 E1008
