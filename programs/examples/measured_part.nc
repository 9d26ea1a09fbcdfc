// A part that lies otherwise than G54 says, and a cutter that is thicker than the table says:
// measured, cut, measured, corrected and cut again (docs/programmer/measuring.md).
//
//   stanok simulate programs/examples/measured_part.nc --machine config/machines/mill3_probe.toml
#include "measure/features.nc"
#include "measure/edges.nc"
#include "measure/write.nc"

// Where the blanks really lie; only the simulation asks G55.
void new_blank () {
  G0 Z60
  G55
  #workpiece (0, 0.04, 0, 60, 26, 6, 30, 13, 6)
  G54
}

// A circular pocket of 14 mm and one of 20 x 12 mm, 4 mm deep.
void cut_pockets () {
  G0 Z50
  T1 M6
  G43
  S6000 M3 F600
  G0 X-15 Y0
  Z5
  G13 I7 Z-4 D1
  G0 Z5
  X14 Y0
  G1 Z-4
  G41 D1 X24 F1200
  Y6
  X4
  Y-6
  X24
  Y0
  G40 X14
  G0 Z50
  M5
}

void probe_in () {
  G53 G0 Z200
  T9 M6
  G43
  G0 Z20
}

void measure_pockets () {
  G0 X-15 Y0
  Z2
  measure_bore (14, -3.2);
  G0 X14 Y0
  measure_slot (Y, 12, -3.2);
  msg ("pocket of 12 mm: " + str (#<_measured_size>, 4));
  G0 X-15 Y0
  measure_bore (14, -3.2);
  msg ("pocket of 14 mm: " + str (#<_measured_size>, 4));
}

settable_zs (1, 2, X, 0.37);
settable_zs (1, 2, Y, -0.21);
settable_zs (1, 2, Z, 0.05);
settable_zs (1, 2, "R", 3);
new_blank ();

probe_in ();
X-20 Y-5
Z3
measure_surface (Z, 0);
measure_write_offset (1);
num passes = 0;
do {
  G0 X-30 Y-13
  measure_outside_corner (1, 1, 5, 15, -4);
  measure_write_offset (1);
  passes += 1;
} while (hypot (#<_measured_error_x>, #<_measured_error_y>) > 0.002 && passes < 5);
msg ("G54: X" + str (gettable_zs (1, 1, X), 4) + " Y" + str (gettable_zs (1, 1, Y), 4)
     + " Z" + str (gettable_zs (1, 1, Z), 4) + ", turned by " + str (gettable_zs (1, 1, "R"), 4));

cut_pockets ();
probe_in ();
measure_pockets ();
measure_demand (#<_measured_size>, 14, 0.1, "pocket");
measure_write_wear_radius (1);

new_blank ();
cut_pockets ();
probe_in ();
measure_pockets ();
G0 Z50
M30
