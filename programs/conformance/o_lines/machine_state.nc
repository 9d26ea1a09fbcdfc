; Predefined parameters, and numbers that show the state of the machine, in programmed units.
G0 X25.4 Y50.8
; expect: rapid X25.4 Y50.8
#1=#<_x> #2=#5421 #3=#<_motion_mode>
G1 X#1 Y#2 Z#3 F50
; expect: line X25.4 Y50.8 Z0 F50
G20 G91
X#<_x> Y#5421 Z#<_plane>
; expect: line X50.8 Y101.6 Z4318 F50
G21 X#<_line> Y[#<_feed> + 2*#<_metric> + #<_imperial>] Z[#<_absolute> * 10 + #<_incremental>]
; expect: line X60.8 Y152.6 Z4319 F50
G90
G55 G0 X#5220 Y#5241 Z#5402
; expect: frame 2 X100 Y200 Z300 B0 C0
; expect: rapid X1 Y100 Z0
X#5220 Y#5242 Z[EXISTS[#<_x>]]
; expect: rapid X2 Y200 Z1
O100 call
; expect: rapid X1 Y2
X#<_call_level>
; expect: rapid X0
X#<_vmajor> Y[EXISTS[#<_vminor>]]
; expect: rapid X2.9 Y1
#5221=1
; expect error 24:1 E3013
M30
O100 sub
  X#<_call_level> Y[#<_call_level> + #<_task>]
O100 endsub
