; The probe of this machine changes at 0, which is 2.5 mm from the place: nothing is written.
G43 H3 G0 Z60
; expect: length H3 0 0 30
; expect: rapid Z60
G37 Z2.5
; expect: rapid Z7.5 stop
; expect: probe contact or alarm Z0.5 F100
; expect: request probe result
M30
; expect error 5:1 E4324
