(dialect haas A)
; channel lathe
; Haas lathe operator's manual, M23 and M24: M23 is in force at power-up, G76 and G92 leave a thread
; over a chamfer; settings 95 and 96 as delivered make it one lead long, at 45 degrees, here at most up
; to where the cycle began. M24 ends threads straight.
G98 G0 X44. Z2. S300 M3
; expect: spindle speed 300
; expect: spindle clockwise 300
; expect: rapid X22 Z2
G76 X38. Z-5. K1. D1. F1.5
; expect: rapid X19
; expect: thread Z-3.5 lead 1.5
; expect: thread X20.5 Z-5 lead 2.121320344
; expect: rapid X22
; expect: rapid Z2
G92 X42. Z-5. F2.
; expect: rapid X21
; expect: thread Z-3 lead 2
; expect: thread X22 Z-4 lead 2.828427125
; expect: rapid Z2
M24
X42. Z-6.
; expect: rapid X21
; expect: thread Z-6 lead 2
; expect: rapid X22
; expect: rapid Z2
G76 X38. Z-5. K1. D1. F1.5
; expect: rapid X19
; expect: thread Z-5 lead 1.5
; expect: rapid X22
; expect: rapid Z2
M23
G92 X42. Z-5. F0.5
; expect: rapid X21
; expect: thread Z-4.5 lead 0.5
; expect: thread X21.5 Z-5 lead 0.7071067812
; expect: rapid X22
; expect: rapid Z2
M30
; expect: spindle stop 0 $-1
; expect: end and rewind
