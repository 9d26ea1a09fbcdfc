// Inner and outer threads by a thread mill, on helices of one lead a turn.
//
// Each begins above the middle of the hole or pin and ends there; F is the feed of the tool's
// middle. The tool turns clockwise and mills with its feed (climb milling): around inside it goes
// counter-clockwise, outside clockwise. A lead below 0 is a left-hand thread. `teeth` is how many
// leads the tool cuts at once.

void thread_refuse (string reason) { terminate (4401, reason); }

void thread_check (num lead, num top, num bottom, num teeth) {
  if (lead == 0) { thread_refuse ("a thread needs a lead"); }
  if (bottom >= top) { thread_refuse ("the bottom of a thread must be below its top"); }
  if (teeth < 1 || teeth != floor (teeth)) {
    thread_refuse ("teeth must be a whole number of at least 1");
  }
  if ($tool_radius <= 0) {
    thread_refuse ("tool " + str ($tool) + " has no radius: it cannot mill a thread");
  }
}

// Half a circle in, `turns` around, half a circle out, with half a lead of height in each half.
void thread_helix_inside (num middle_x, num middle_y, num radius, num from_z, num lead, num turns) {
  G0 Z=from_z-lead/2
  G3 X=middle_x+radius Y=middle_y Z=from_z I=radius/2 J0
  G3 X=middle_x+radius Y=middle_y Z=from_z+turns*lead I=-radius J0 P=turns
  G3 X=middle_x Y=middle_y Z=from_z+turns*lead+lead/2 I=-radius/2 J0
}

// Outside the tool comes and goes by half a circle beside the pin, in the height where it is.
void thread_helix_outside (num middle_x, num middle_y, num radius, num beside, num from_z,
                           num lead, num turns) {
  G0 Z=from_z
  G3 X=middle_x+radius Y=middle_y I=-beside J0
  G2 X=middle_x+radius Y=middle_y Z=from_z-turns*lead I=-radius J0 P=turns
  G3 X=middle_x+radius+2*beside Y=middle_y I=beside J0
}

// `diameter` is the largest one of the thread.
void mill_inner_thread (num diameter, num lead, num top, num bottom, num teeth = 1) {
  M73
  thread_check (lead, top, bottom, teeth);
  G90 G91.1 G17
  num middle_x = $prog_pos[X], middle_y = $prog_pos[Y], height = $prog_pos[Z];
  num radius = diameter/2 - $tool_radius;
  if (radius <= 0) { thread_refuse ("the tool does not fit into the thread"); }
  num leads = ceil ((top - bottom)/abs (lead) - 1e-9), turns = leads, steps = 1;
  if (teeth > 1) {
    steps = ceil (leads/teeth);
    turns = 1;
  }
  num from_z = bottom;
  if (lead < 0) { from_z = bottom - leads*lead; }
  for (num idx = 0; idx < steps; idx++) {
    thread_helix_inside (middle_x, middle_y, radius, from_z + idx*teeth*lead, lead, turns);
  }
  G0 Z=height
}

// `diameter` is the smallest one of the thread; `beside` is how far from it the tool comes down, its
// radius where it is left out.
void mill_outer_thread (num diameter, num lead, num top, num bottom, num teeth = 1,
                        num beside = 0) {
  M73
  thread_check (lead, top, bottom, teeth);
  G90 G91.1 G17
  num middle_x = $prog_pos[X], middle_y = $prog_pos[Y], height = $prog_pos[Z];
  num radius = diameter/2 + $tool_radius, half = beside/2;
  if (half <= 0) { half = $tool_radius/2; }
  num leads = ceil ((top - bottom)/abs (lead) - 1e-9), turns = leads, steps = 1;
  if (teeth > 1) {
    steps = ceil (leads/teeth);
    turns = 1;
  }
  num from_z = bottom + leads*lead;
  if (lead < 0) { from_z = bottom; }
  G0 X=middle_x+radius+2*half
  for (num idx = 0; idx < steps; idx++) {
    thread_helix_outside (middle_x, middle_y, radius, half, from_z - idx*teeth*lead, lead, turns);
  }
  G0 Z=height
  X=middle_x
}
