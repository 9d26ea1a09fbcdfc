// What becomes of a measurement: tolerances, work offsets, wear.
#include "touch.nc"

// Whether a value is right within a tolerance to both sides; the program decides.
bool measure_is_within (num value, num nominal, num tolerance) {
  return abs (value - nominal) <= tolerance;
}

// The same with an alarm: U4327, before anything is written.
void measure_demand (num value, num nominal, num tolerance, string name) {
  if (measure_is_within (value, nominal, tolerance)) { return; }
  terminate (4327, name + " is " + str (value, 4) + ", " + str (value - nominal, 4)
                   + " off; the tolerance is " + str (tolerance, 4));
}

// Turns and shifts a work offset, 1 for G54 to 9 for G59.3, so that what was measured has the
// coordinates that it should have. It is the active one (U4328). Both are written without motion.
void measure_write_offset (num page) {
  if (page != #<_coord_system>/10-53) {
    if (page < 7 || page != 6 + (#<_coord_system> - 590)) {
      terminate (4328, "the work offset to be written is not the active one");
    }
  }
  num turn = #<_measured_angle>;
  num wanted_x = #<_measured_x> - #<_measured_error_x>;
  num wanted_y = #<_measured_y> - #<_measured_error_y>;
  num found_x = #<_measured_x>, found_y = #<_measured_y>;
  if (turn != 0) {
    num rotation = gettable_zs (1, page, "R") + turn;
    G10 L2 P=page R=rotation
    found_x = #<_measured_x>*cos (turn) + #<_measured_y>*sin (turn);
    found_y = #<_measured_y>*cos (turn) - #<_measured_x>*sin (turn);
    if (#<_measured_error_x> == 0 && #<_measured_error_y> == 0) { return; }
  }
  num next_x = $prog_pos[X] + wanted_x - found_x;
  num next_y = $prog_pos[Y] + wanted_y - found_y;
  num next_z = $prog_pos[Z] - #<_measured_error_z>;
  G10 L20 P=page X=next_x Y=next_y Z=next_z
}

// A wear is corrected by at most #<_measure_wear_max>: more is U4329, and nothing is written.
void measure_add_wear (num tool, num edge, string name, num change) {
  measure_settings ();
  num most = #<_measure_wear_max>*measure_mm ();
  if (abs (change) > most) {
    terminate (4329, name + " of tool " + str (tool) + " would change by " + str (change, 4)
                     + "; the limit is " + str (most, 4));
  }
  num before = gettable_tool (tool, edge, name);
  settable_tool (tool, edge, name, before + change);
}

// Of the tool that has made a bore, slot, boss or web of the size that was measured.
void measure_write_wear_radius (num tool, num edge = 1) {
  measure_settings ();
  if (abs (#<_measured_size_kind>) != 1) {
    terminate (4328, "the last measurement was not a bore, slot, boss or web");
  }
  measure_add_wear (tool, edge, "wear_radius",
                    #<_measured_size_kind>*#<_measured_size_error>/2);
}

// Of the tool that has made a face across Z: one that is too deep was made by a longer tool.
void measure_write_wear_length (num tool, num edge = 1) {
  measure_add_wear (tool, edge, "wear_length", -#<_measured_error_z>);
}

// Lays the program on the plane that measure_plane has found, by G54.4: turned about X and Y until
// Z is its normal, and shifted along that to its height. Again under G54.4: on top of nothing else,
// so end it (`G54.4 P0`) before the plane is measured again.
void measure_write_set_up () {
  measure_settings ();
  if (#<_measured_size_kind> != MEASURE_PLANE) {
    terminate (4328, "the last measurement was not a plane");
  }
  num n_x = #<_measured_normal_x>, n_y = #<_measured_normal_y>, n_z = #<_measured_normal_z>;
  num face = #<_measured_z> - #<_measured_error_z>;
  num off = n_x*#<_measured_x> + n_y*#<_measured_y> + n_z*#<_measured_z> - face;
  num turn_x = -asin (n_y), turn_y = atan (n_x/n_z);
  num shift_x = n_x*off, shift_y = n_y*off, shift_z = n_z*off;
  G54.4 X=shift_x Y=shift_y Z=shift_z I=turn_x J=turn_y
}
