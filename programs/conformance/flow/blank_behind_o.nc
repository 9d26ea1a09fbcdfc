(dialect linuxcnc)
; LinuxCNC leaves blanks out: a label may stand apart from its O. G64 R, the planner of its 2.10, says
; nothing here; parameters that its 2.9 has.
o <made up> sub
  G0 X[#<_adaptive_feed> + 2 * #<_feed_hold> + #<_remap_level>]
o <made up> endsub
G64 P0.01 R0.5
o <made up> call
; expect: rapid X2 tolerance 0.01
O 10 repeat [2]
  G91 G0 X1
; expect: rapid X3 tolerance 0.01
; expect: rapid X4 tolerance 0.01
O 10 endrepeat
G90
M2
; expect: end
