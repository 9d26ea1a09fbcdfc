(dialect haas)
; M79 is an alarm when the last skip touched nothing, M78 when it touched something; they stand in the
; block of the skip or in a later one (Haas mill operator's manual, M78 and M79). The probe touches here.
G31 X3 F50 M79
; expect: probe contact X3 F50
; expect: request probe result
M79
G0 X1
; expect: rapid X1
M30
; expect: end and rewind
