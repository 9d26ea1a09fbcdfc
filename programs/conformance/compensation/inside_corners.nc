; Inside corners end where the parallels meet; on the inside of an arc the radius is smaller by the
; tool's. G41.1 D is a diameter. Other axes go with their block.
F100 G0 X0 Y10 Z0
; expect: rapid X0 Y10 Z0
G41.1 D4 G1 X0 Y0
; expect: line X0 Y2 F100
X20
; expect: line X18 Y2 F100
Y20
; expect: line X18 Y20 F100
G3 X10 Y30 Z-1 I-10
; expect: arc ccw xy centre 10,20 X10 Y28 Z-1 F100
G1 X0
; expect: line X0 Y28 F100
G40 Y20
; expect: line X0 Y20 F100
M30
; expect: end and rewind
