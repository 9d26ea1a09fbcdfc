(dialect fanuc A)
; channel lathe
; Fanuc operator's manual B-64304EN-1, multiple threading: Q is the angle of the spindle in
; thousandths of a degree, without a point; it is not modal. With a point, which that control
; refuses, it is degrees.
G98 G0 X40. Z2. S300 M3
; expect: spindle speed 300
; expect: spindle clockwise 300
; expect: rapid X20 Z2
G32 Z-10. F2. Q0
; expect: thread Z-10 lead 2
G0 Z2.
; expect: rapid Z2
G32 Z-10. F2. Q180000
; expect: thread Z-10 lead 2 angle 180
G0 Z2.
; expect: rapid Z2
G32 Z-10. F2. Q90
; expect: thread Z-10 lead 2 angle 0.09
Z-12. F2.
; expect: thread Z-12 lead 2
G0 Z2.
; expect: rapid Z2
G92 X38. Z-5. F1.5 Q180000
; expect: rapid X19
; expect: thread Z-5 lead 1.5 angle 180
; expect: rapid X20
; expect: rapid Z2
X37.
; expect: rapid X18.5
; expect: thread Z-5 lead 1.5
; expect: rapid X20
; expect: rapid Z2
X37. Q120.
; expect: rapid X18.5
; expect: thread Z-5 lead 1.5 angle 120
; expect: rapid X20
; expect: rapid Z2
G92 X36. Q360001
; expect error 39:10 E4016
M30
