(dialect haas)
G47 P1 J6. R5. Z-.2 (SERIAL)
; expect error 2:1 E4008
G47 P2 J6. R5. Z-.2 (A)
; expect error 4:5 E4008
G47 P0 J6. R5. Z-.2
; expect error 6:1 E4007
G47 P0 R5. Z-.2 (A)
; expect error 8:1 E4007
G47 P0 J6. Z-.2 Q3 (A)
; expect error 10:17 E4003
M30
