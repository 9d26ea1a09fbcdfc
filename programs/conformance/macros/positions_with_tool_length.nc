(dialect fanuc)
; Fanuc B-64304EN, 16.2, position information: #5001 is without the tool compensation value, #5041 and
; #5061 have it included, #5081 is the value. So macros find the active length as #5043-#5003, and the
; tip at a touch as #5063-#5083. The probe of this machine changes at 0.
G43 H3 Z50 F100
; expect: length H3 0 0 30
; expect: rapid Z50
#1=#5003
#2=#5043
; expect: request sync
X#1 Y#2
; expect: rapid X50 Y80
G31 Z20
; expect: probe contact Z20 F100
; expect: request probe result
#3=#5063
G49
; expect: length off
#4=#5043
; expect: request sync
X#3 Y#4
; expect: rapid X30 Y50
M30
; expect: end and rewind
