// Surface, bore, boss, sphere, slot and web: where they are, and how large.
//
// Each begins above the place where the middle should be and ends there; `at_z` is the height of
// the touches. What was found is in #<_measured_x>, .._y, .._z, #<_measured_size>, and as a
// difference from where it should be in #<_measured_error_x>, .._y, .._z, #<_measured_size_error>.
#include "touch.nc"

void measure_keep_size (num size, num nominal, num kind) {
  #<_measured_size>=size
  #<_measured_size_error>=size-nominal
  #<_measured_size_kind>=kind
}

string measure_told_size () {
  return measure_told ("size", #<_measured_size>)
         + measure_told ("error_size", #<_measured_size_error>);
}

string measure_told_middle () {
  return measure_told ("x", #<_measured_x>) + measure_told ("y", #<_measured_y>)
         + measure_told ("error_x", #<_measured_error_x>)
         + measure_told ("error_y", #<_measured_error_y>);
}

void measure_keep_middle (num middle[], num start[]) {
  #<_measured_x>=middle[0]
  #<_measured_y>=middle[1]
  #<_measured_error_x>=middle[0]-start[0]
  #<_measured_error_y>=middle[1]-start[1]
}

// A face that is found further before its place than it is looked for behind it was none: U4325.
void measure_refuse_early (num before) {
  if (before <= #<_measure_search>*measure_mm ()) { return; }
  terminate (4325, "the probe touched " + str (before, 3) + " before the face");
}

// One face across an axis that should be at `face`: from here along that axis.
void measure_surface (axis across, num face) {
  M73
  measure_begin ();
  num to[3], touch[3];
  measure_here (to);
  num search = #<_measure_search>*measure_mm (), radius = measure_radius (), side = -1;
  if (across == X) {
    side = sign (face - to[0]);
    to[0] = face + side*search;
    measure_touch (to, search + radius, touch);
    measure_refuse_early (side*(face - touch[0]) - radius);
    #<_measured_x>=touch[0]+side*radius
    #<_measured_error_x>=touch[0]+side*radius-face
    measure_report ("surface_x", measure_told ("x", #<_measured_x>)
                    + measure_told ("error_x", #<_measured_error_x>));
  } else if (across == Y) {
    side = sign (face - to[1]);
    to[1] = face + side*search;
    measure_touch (to, search + radius, touch);
    measure_refuse_early (side*(face - touch[1]) - radius);
    #<_measured_y>=touch[1]+side*radius
    #<_measured_error_y>=touch[1]+side*radius-face
    measure_report ("surface_y", measure_told ("y", #<_measured_y>)
                    + measure_told ("error_y", #<_measured_error_y>));
  } else {
    to[2] = face - search;
    measure_touch (to, search, touch);
    measure_refuse_early (touch[2] - face);
    #<_measured_z>=touch[2]
    #<_measured_error_z>=touch[2]-face
    measure_report ("surface_z", measure_told ("z", #<_measured_z>)
                    + measure_told ("error_z", #<_measured_error_z>));
  }
}

// Two faces across X or Y and the middle between them.
void measure_pair (num inside, axis across, num width, num at_z) {
  num start[3], middle[3];
  measure_here (start);
  measure_here (middle);
  num dir_x = across == X ? 1 : 0;
  num dir_y = 1 - dir_x;
  if (inside > 0) { measure_go (start[0], start[1], at_z); }
  num plus = measure_side (inside, middle, dir_x, dir_y, width/2, at_z, start[2]);
  num minus = measure_side (inside, middle, -dir_x, -dir_y, width/2, at_z, start[2]);
  middle[0] += dir_x*(plus - minus)/2;
  middle[1] += dir_y*(plus - minus)/2;
  if (inside > 0) { measure_go (start[0], start[1], at_z); }
  measure_go (start[0], start[1], start[2]);
  measure_keep_middle (middle, start);
  measure_keep_size (plus + minus + inside*2*measure_radius (), width, inside);
}

void measure_slot (axis across, num width, num at_z) {
  M73
  measure_begin ();
  measure_pair (MEASURE_INSIDE, across, width, at_z);
  measure_report ("slot", measure_told_middle () + measure_told_size ());
}

void measure_web (axis across, num width, num at_z) {
  M73
  measure_begin ();
  measure_pair (MEASURE_OUTSIDE, across, width, at_z);
  measure_report ("web", measure_told_middle () + measure_told_size ());
}

// Four touches about the middle. The passes begin at the middle that the one before has found,
// until it stays where it is: off the middle the first pair is a chord, no diameter.
void measure_circle (num inside, num diameter, num at_z) {
  num start[3], middle[3], last[3];
  measure_here (start);
  measure_here (middle);
  num plus = 0, minus = 0, size_x = 0, size_y = 0, passes = 0, moved = 0;
  if (inside > 0) { measure_go (start[0], start[1], at_z); }
  do {
    last[0] = middle[0];
    last[1] = middle[1];
    plus = measure_side (inside, middle, 1, 0, diameter/2, at_z, start[2]);
    minus = measure_side (inside, middle, -1, 0, diameter/2, at_z, start[2]);
    size_x = plus + minus;
    middle[0] += (plus - minus)/2;
    plus = measure_side (inside, middle, 0, 1, diameter/2, at_z, start[2]);
    minus = measure_side (inside, middle, 0, -1, diameter/2, at_z, start[2]);
    size_y = plus + minus;
    middle[1] += (plus - minus)/2;
    moved = hypot (middle[0] - last[0], middle[1] - last[1]);
    passes += 1;
    if (passes > #<_measure_repeat>) {
      terminate (4326, "the center still moves by " + str (moved, 4) + " from pass to pass");
    }
  } while (moved > #<_measure_within>*measure_mm ());
  if (inside > 0) { measure_go (start[0], start[1], at_z); }
  measure_go (start[0], start[1], start[2]);
  measure_keep_middle (middle, start);
  measure_keep_size ((size_x + size_y)/2 + inside*2*measure_radius (), diameter, inside);
}

void measure_bore (num diameter, num at_z) {
  M73
  measure_begin ();
  measure_circle (MEASURE_INSIDE, diameter, at_z);
  measure_report ("bore", measure_told_middle () + measure_told_size ());
}

void measure_boss (num diameter, num at_z) {
  M73
  measure_begin ();
  measure_circle (MEASURE_OUTSIDE, diameter, at_z);
  measure_report ("boss", measure_told_middle () + measure_told_size ());
}

// A ball, from above: four touches about it at the height of its middle and one on its top, again
// from the middle that was found, until that stays where it is. `top` is where its top should be.
void measure_sphere (num diameter, num top) {
  M73
  measure_begin ();
  num start[3], touch[3], middle[3] = {0, 0, top - diameter/2};
  measure_here (start);
  num search = #<_measure_search>*measure_mm (), moved = 0, passes = 0, size = 0, last_z = 0;
  middle[0] = start[0];
  middle[1] = start[1];
  do {
    measure_circle (MEASURE_OUTSIDE, diameter, middle[2] - measure_radius ());
    size = #<_measured_size>;
    last_z = middle[2];
    middle[0] = #<_measured_x>;
    middle[1] = #<_measured_y>;
    measure_go (middle[0], middle[1], start[2]);
    num to[3] = {middle[0], middle[1], top - search};
    measure_touch (to, search, touch);
    measure_refuse_early (touch[2] - top);
    middle[2] = touch[2] - size/2;
    moved = abs (middle[2] - last_z);
    passes += 1;
    if (passes > #<_measure_repeat>) {
      terminate (4326, "the center still moves by " + str (moved, 4) + " from pass to pass");
    }
  } while (moved > #<_measure_within>*measure_mm ());
  measure_go (start[0], start[1], start[2]);
  measure_keep_middle (middle, start);
  measure_keep_size (size, diameter, MEASURE_OUTSIDE);
  num error_z = middle[2] - (top - diameter/2);
  #<_measured_z>=middle[2]
  #<_measured_error_z>=error_z
  measure_report ("sphere", measure_told_middle () + measure_told ("z", middle[2])
                  + measure_told ("error_z", error_z) + measure_told_size ());
}
