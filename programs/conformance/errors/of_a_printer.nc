; A program of a slicer.
G28
G92 E0
M104 S200
; expect error 4:1 E2042
G1 X10 Y10 E0.5 F1800
G1 X20 E0.9
