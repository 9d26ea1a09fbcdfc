(dialect linuxcnc)
; The radii may differ by 2 * sqrt 2 * 0.01 mm, or by a thousandth up to a hundred times of that.
; Source: LinuxCNC, interp_arc.cc; expected values as tests/interp/good and tests/interp/bad there.
F100 G2 X50 I[25-0.0099*SQRT[2]]
; expect: arc cw xy centre 24.98599929,0 X50 F100
G0 X0
; expect: rapid X0
G2 X2000 I999.5
; expect: arc cw xy centre 999.5,0 X2000 F100
G0 X0
; expect: rapid X0
G2 X6000 I[3000+0.99*SQRT[2]]
; expect: arc cw xy centre 3001.400071,0 X6000 F100
G0 X0
; expect: rapid X0
G2 X6000 I3001.4284
; expect error 16:1 E4032
M30
