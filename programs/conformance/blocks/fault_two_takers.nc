; Neither two codes without motion nor one beside a motion share the axis words.
G52 X1 G92 Y2
G52 X1 G1 Y2
M30
; expect error 2:8 E4006
; expect error 3:8 E4006
