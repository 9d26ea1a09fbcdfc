; M66: P is digital and E analog; L is 0 at once, 1 rise, 2 fall, 3 on, 4 off; without L at once.
M66 P1
; expect: request wait for input 1 mode 0 timeout 0
M66 P1 L1 Q5
; expect: request wait for input 1 mode 1 timeout 5
M66 P1 L2 Q5
; expect: request wait for input 1 mode 2 timeout 5
M66 P1 L4 Q0.5
; expect: request wait for input 1 mode 4 timeout 0.5
M66 E2 L0
; expect: request wait for input 2 analog mode 0 timeout 0
M30
; expect: end and rewind
