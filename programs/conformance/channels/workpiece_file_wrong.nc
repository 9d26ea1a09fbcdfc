#workpiece (2, 0.5, 0, "box_40_30_10.stl", 20, 15)
; expect error 1:1 E3005
#workpiece (2, 0.5, 0, "missing.stl", 20, 15, 10)
; expect error 3:24 E7001
#workpiece (2, 0.5, 0, "shares.nc", 20, 15, 10)
; expect error 5:24 E7020
#workpiece (2, 0.5, 0, "box_40_30_10.stl", 20, 15, "a")
; expect error 7:52 E3004
M30
