(dialect haas)
G47 P1 J6. R5. Z-.2 (S####)
; expect error 2:5 E2090
G47 P0 J6. R5. Z-.2
; expect error 4:1 E4007
G47 P0 R5. Z-.2 (A)
; expect error 6:1 E4007
G47 P0 J6. Z-.2 Q3 (A)
; expect error 8:17 E4003
M30
