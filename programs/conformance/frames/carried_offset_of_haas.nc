(dialect haas)
; G254: the table carries the offset that is active, as G54.2 does here; G255 ends it. G55 is at X100
; Y200, C turns about X100 Y0 (carried_offset.nc).
G55
; expect: frame 2 X100 Y200 Z300 B0 C0
G254
G0 X1 Y2 C90
; expect: frame 2 X-100 Y0 Z300 B0 C0
; expect: rapid X1 Y2 C90
G255
; expect: frame 2 X100 Y200 Z300 B0 C0
X0
; expect: rapid X0
M30
; expect: end and rewind
