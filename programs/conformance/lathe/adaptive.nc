; channel lathe
; Orders to force control: clamps in the units of F, inches as mm; values left out are 0.
G21 G90 G18 G8 G95
#adaptive (force, 1200, 0.05, 0.6)
; expect: adaptive force P_z=1200 S_min=0.05 S_max=0.6 per revolution
G94
#adaptive (force, 2*400, 30, 240)
; expect: adaptive force P_z=800 S_min=30 S_max=240
G20
#adaptive (force, 900, 1, 10)
; expect: adaptive force P_z=900 S_min=25.4 S_max=254
G21
#adaptive (force, 1000)
; expect: adaptive force P_z=1000
num amplitude = 60;
#adaptive (oscillate, amplitude, 4)
; expect: adaptive oscillate P_osc=60 f=4
#adaptive (oscillate, 0, 4)
; expect: adaptive oscillate f=4
#adaptive (vibration, on)
; expect: adaptive vibration on
#adaptive (vibration, on, 5, 2.5, 4)
; expect: adaptive vibration on f=4 level=5 m_d=2.5
#adaptive (vibration, off)
; expect: adaptive vibration off
#adaptive (depth, 2.5)
; expect: adaptive depth t=2.5
G20
#adaptive (depth, 0.1)
; expect: adaptive depth t=2.54
G21
#adaptive (off)
; expect: adaptive off
M30
; expect: end and rewind
