; The blank is the solid of an STL file: zero in its coordinates, the scale in mm for a unit of it.
#workpiece (2, 0.5, 0, "box_40_30_10.stl", 20, 15, 10)
; expect: workpiece file box_40_30_10.stl milling 0.5 40 30 10 20 15 10
G20
#workpiece (2, 0.5, 1, "box_40_30_10.stl", 1, 0, 2, 25.4)
; expect: workpiece file box_40_30_10.stl turning 0.5 1016 762 254 25.4 0 50.8
G21
num small = 0.01;
#workpiece (2, 0.5, 0, "box_40_30_10.stl", 0, 0, 0, small)
; expect error 9:1 E3021
M30
