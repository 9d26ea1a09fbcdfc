; G37 by the manual of Fanuc (automatic tool length measurement): at rapid up to 5 mm before the
; place, at the measuring feed up to 2 mm behind it; the wear becomes wear + (touch - place). The
; probe of this machine changes at 0: the tool is 0.25 mm shorter than the table says.
G43 H3 G0 Z60
; expect: length H3 0 0 30
; expect: rapid Z60
G37 Z0.25
; expect: rapid Z5.25 stop
; expect: probe contact or alarm Z-1.75 F100
; expect: request probe result
; expect: request write tool channel 5 3 wear_length -0.25
; expect: length H3 0 0 29.75
M30
; expect: end and rewind
