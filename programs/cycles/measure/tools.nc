// Tools at a tool setter, and the probe itself.
//
// G59.3 is the setter: its zero is the middle of the upper face of its disc, in the machine without
// tool length. The cycles go there by themselves, at the height where they begin, and come back to
// that height; offset, length and modal state are those from before.
#include "touch.nc"
#include "features.nc"
#include "write.nc"

// Of the tool in the spindle.
void measure_keep_tool (num size, num nominal, num kind) {
  measure_keep_size (size, nominal, kind);
  #<_measured_tool>=$tool
}

// What is written is what was measured last, of the tool that is still in the spindle (U4328).
void measure_demand_tool (num kind, string name) {
  measure_settings ();
  if (#<_measured_size_kind> != kind || #<_measured_tool> != $tool) {
    terminate (4328, "the last measurement was not the " + name + " of tool " + str ($tool));
  }
}

// The length of the tool in the spindle: #<_measured_size>, and #<_measured_size_error> against the
// table. `about`: where to look; without it the length of the table.
void measure_tool_length (num about = 0) {
  M73
  measure_settings ();
  num expected = about > 0 ? about : measure_length ();
  if ($tool == 0 || expected <= 0) {
    terminate (4323, "no tool of a known length is active; give its approximate length");
  }
  G49 G59.3 G90 G94
  num start[3], touch[3];
  measure_here (start);
  num before = expected + #<_measure_search>*measure_mm ();
  if (start[2] < before) { terminate (4324, "the cycle begins too low over the tool setter"); }
  G0 X0 Y0
  measure_go (0, 0, before);
  num to[3] = {0, 0, expected - #<_measure_search>*measure_mm ()};
  measure_touch (to, #<_measure_search>*measure_mm (), touch);
  measure_go (0, 0, start[2]);
  measure_keep_tool (touch[2], measure_length (), MEASURE_TOOL_LENGTH);
  measure_report ("tool_length", " tool=" + str ($tool) + measure_told_size ());
}

// The wear that makes the table say what was measured last.
void measure_write_tool_length () {
  measure_demand_tool (MEASURE_TOOL_LENGTH, "length");
  measure_add_wear ($tool, $edge, "wear_length", #<_measured_size_error>);
}

// The radius of the tool in the spindle, from both sides of the disc at `depth` below its upper
// face: #<_measured_size>, and #<_measured_size_error> against the table.
void measure_tool_radius (num disc, num depth) {
  M73
  measure_settings ();
  num length = measure_length (), radius = measure_radius ();
  if ($tool == 0 || length <= 0 || radius <= 0) {
    terminate (4323, "the table has no length or no radius of the tool");
  }
  G49 G59.3 G90 G94
  num start[3], middle[3] = {0, 0, 0};
  measure_here (start);
  G0 X0 Y0
  num plus = measure_side (-1, middle, 1, 0, disc/2, length - depth, start[2]);
  num minus = measure_side (-1, middle, -1, 0, disc/2, length - depth, start[2]);
  measure_go (0, 0, start[2]);
  num found = (plus + minus - disc)/2;
  measure_keep_tool (found, radius, MEASURE_TOOL_RADIUS);
  measure_report ("tool_radius", " tool=" + str ($tool) + measure_told_size ());
}

void measure_write_tool_radius () {
  measure_demand_tool (MEASURE_TOOL_RADIUS, "radius");
  measure_add_wear ($tool, $edge, "wear_radius", #<_measured_size_error>);
}

// Whether the tool in the spindle is shorter than the table says, by more than `missing`. Neither
// length nor wear is written.
bool measure_is_broken (num missing) {
  M73
  measure_settings ();
  num length = measure_length ();
  if ($tool == 0 || length <= missing) { terminate (4323, "the table has no length of the tool"); }
  G49 G59.3 G90 G94
  num start[3];
  measure_here (start);
  num before = length + #<_measure_clear>*measure_mm ();
  G0 X0 Y0
  measure_go (0, 0, before);
  num least = length - missing;
  G38.3 Z=least F=#<_measure_fast>*measure_mm ()
  bool broken = $probe_ok == false;
  if (broken && $prog_pos[Z] > least + MEASURE_SHORTEST*measure_mm ()) {
    G38.2 Z=least F=#<_measure_fast>*measure_mm ()
  }
  G0 Z=start[2]
  measure_report ("tool_breakage", " tool=" + str ($tool) + " broken=" + (broken ? "1" : "0"));
  return broken;
}

// The probe in a ring of known diameter whose middle is where the cycle begins: writes the radius
// with which the ball acts (wear of the radius) and where it hangs beside the axis (lengths along X
// and Y, for probes that always stand with one side to the front). G43 comes again behind it.
void measure_calibrate_ring (num diameter, num at_z) {
  M73
  measure_begin ();
  measure_circle (MEASURE_INSIDE, diameter, at_z);
  measure_report ("ring", measure_told_middle () + measure_told_size ());
  num off_x = #<_measured_error_x>, off_y = #<_measured_error_y>;
  measure_add_wear ($tool, $edge, "wear_radius", -#<_measured_size_error>/2);
  num beside_y = gettable_tool ($tool, $edge, "length_y");
  measure_add_wear ($tool, $edge, "wear_length_x", off_x);
  settable_tool ($tool, $edge, "length_y", beside_y + off_y);
}

// The length of the probe at a face of known height under it.
void measure_calibrate_length (num height) {
  measure_surface (Z, height);
  measure_add_wear ($tool, $edge, "wear_length", #<_measured_error_z>);
}
