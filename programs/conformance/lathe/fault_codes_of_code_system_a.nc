; channel lathe
; What code system A understands differently is refused when the program is loaded.
G98 G1 X40 F100
G99 F0.2
G50 X100 Z50
G92 X30 Z-20 F1.5
G94 X20 Z-1 F0.1
G20 X48 Z-30 F0.2
; These say the same everywhere.
G90 G0 X50
G91 X-5
G90 X40
G94 G1 X39 F100
G92 X0 Z0
M30
; expect error 3:1 E4016
; expect error 4:1 E4016
; expect error 5:1 E4016
; expect error 6:14 E4016
; expect error 7:1 E4016
; expect error 8:1 E4016
