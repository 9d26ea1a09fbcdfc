; A spindle becomes the axis C and a spindle again; the program waits for both.
; channel spindle axis
S500 M3
; expect: spindle speed 500
; expect: spindle clockwise 500
M902 H1=1
; expect: spindle stop 500 $1
; expect: request spindle_to_axis 1
G1 C90 F600
; expect: line C90 F600
M903
; expect: request axis_to_spindle 1
M30
; expect: end and rewind
