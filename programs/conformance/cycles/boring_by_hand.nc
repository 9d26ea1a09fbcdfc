; G88 on mills by the manuals of Fanuc and of the NIST interpreter (3.5.16.8): to the bottom, the
; dwell, the spindle and the program stop; when it is started again, the spindle turns as before and
; the tool goes on to the level of G98 or G99.
S800 M3 F50
; expect: spindle speed 800
; expect: spindle clockwise 800
G0 Z5
; expect: rapid Z5
G98 G88 X10 Z-8 R2 P0.5
; expect: rapid X10
; expect: rapid Z2
; expect: line Z-8 F50
; expect: dwell 0.5
; expect: spindle stop 0
; expect: program stop
; expect: request sync
; expect: rapid Z2
; expect: spindle clockwise 800
; expect: rapid Z5
G91 G99 X5 L2
; expect: rapid X15
; expect: rapid Z2
; expect: line Z-8 F50
; expect: dwell 0.5
; expect: spindle stop 0
; expect: program stop
; expect: request sync
; expect: rapid Z2
; expect: spindle clockwise 800
; expect: rapid X20
; expect: line Z-8 F50
; expect: dwell 0.5
; expect: spindle stop 0
; expect: program stop
; expect: request sync
; expect: rapid Z2
; expect: spindle clockwise 800
M30
; expect: spindle stop 0 $-1
; expect: end and rewind
