(dialect fanuc A)
; channel lathe
; G10 of lathes (B-64304EN-1, 5.1.6): P is the wear, P10001 and on the geometry; X is a diameter.
G10 P2 X0.2 Z-0.1 R0.05
; expect: request write tool channel 11 2 wear_length_x 0.1
; expect: request write tool channel 5 2 wear_length -0.1
; expect: request write tool channel 6 2 wear_radius 0.05
G10 P10002 X80. Z40. R0.8 Q3
; expect: request write tool channel 3 2 length_x 40
; expect: request write tool channel 1 2 length 40
; expect: request write tool channel 4 2 radius 0.8
; expect: request write tool channel 8 2 orientation 3
G10 L2 P1 X20. Z5.
; expect: request write offset channel 1 1 X 10
; expect: request write offset channel 1 1 Z 5
#1=#2002
; expect: request read tool channel 11 2
#2702=60.
; expect: request write tool channel 3 2 30
M30
; expect: end and rewind
