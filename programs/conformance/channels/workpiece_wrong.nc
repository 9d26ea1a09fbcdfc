#workpiece (0, 0.5, 0, 100, 80, 40, 50, 40)
; expect error 1:1 E3005
#workpiece_pos (1, 2, 3)
; expect error 3:1 E3005
#workpiece_pos (1, 2, 3, 4, 5, "a")
; expect error 5:32 E3004
M30
