; END1 could close both.
DO1
WHILE [#1 LT 3] DO1
END1
END1
M30
; expect error 3:1 E2013
; expect error 5:1 E2013
