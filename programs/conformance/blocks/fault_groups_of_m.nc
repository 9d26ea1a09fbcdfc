; One M code of a group; M9 is one of both coolants, outputs and inputs are a group.
M3 M4
M8 M9
M7 M9
M6 M61 Q1
M48 M49
M62 P1 M66 L0
M7 M8 M3 M48 M64 P1
M0 M30
; expect error 2:4 E4002
; expect error 3:4 E4002
; expect error 4:4 E4002
; expect error 5:4 E4002
; expect error 6:5 E4002
; expect error 7:8 E4002
; expect error 9:4 E4002
