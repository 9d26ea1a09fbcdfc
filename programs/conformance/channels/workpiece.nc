; For displays only: nothing stops, and sizes follow the units of the program.
#workpiece (0, 0.5, 0, 100, 80, 40, 50, 40, 40)//a block
; expect: workpiece box milling 0.5 100 80 40 50 40 40
#workpiece_pos (10, 20, -5, 0, 90, 180);
; expect: workpiece position 10 20 -5 0 90 180
G20
#workpiece (1, 0.5, 1, 2, 1, 10, 0, 0, 10)
; expect: workpiece cylinder turning 0.5 50.8 25.4 254 0 0 254
num wide = 4;
#workpiece (1, 0.5, 1, 2, wide, 10, 0, 0, 10)
; expect error 10:1 E3021
M30
