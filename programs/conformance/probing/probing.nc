; A line, then the program waits for what was found.
G38.2 Z-10 F50
; expect: probe contact or alarm Z-10 F50
; expect: request probe result
G38.5 X1 Y2
; expect: probe loss X1 Y2 F50
; expect: request probe result
G38.4 X2
; expect: probe loss or alarm X2 F50
; expect: request probe result
G38.3 Y0
; expect: probe contact Y0 F50
; expect: request probe result
G31 X3
; expect: probe contact X3 F50
; expect: request probe result
if ($probe_ok == true) { msg ("found " + str (#5070)); }
; expect: message found 1
M30
; expect: end and rewind
