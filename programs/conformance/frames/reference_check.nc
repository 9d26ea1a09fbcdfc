; G27 goes to its words, which are the reference point of the named axes in machine coordinates.
G0 X10 Y20 Z30
; expect: rapid X10 Y20 Z30
G28.1
G55
; expect: frame 2 X100 Y200 Z300 B0 C0
G27 X-90 Z-270
; expect: rapid X-90 Z-270
G91 G27 Y0
; expect: rapid Y-180
G90 G43.1 Z5
; expect: length H0 0 0 5
G27 Z-275
; expect: rapid Z-275
; A modulo axis may have made turns.
G91 G0 C360
; expect: rapid C360
G90 G27 B0 C0
; expect: rapid B0 C360
M30
; expect: end and rewind
