// The core of all measuring cycles: moves that must not touch, and touches that are repeated.
//
// Points are arrays of X, Y and Z in programmed coordinates, in whatever work offset, rotation and
// tilted plane is active; of the probe X and Y are the middle of the ball, Z is its lowest point.
// Settings are channel variables in mm, whatever the units of the program; the first cycle sets
// those that the program has not set:
//   #<_measure_travel>   feed between touches, which a touch ends, mm/min   2000
//   #<_measure_fast>     feed of the first touch                             300
//   #<_measure_feed>     feed of the touches that count                       30
//   #<_measure_search>   how far beyond its place a face is looked for          5
//   #<_measure_clear>    how far before its place the first touch begins        2
//   #<_measure_within>   touches, and middles found, that agree                 0.002
//   #<_measure_repeat>   touches, and passes, until they must agree             5
//   #<_measure_wear_max> the most by which a wear is corrected                   0.5

const num MEASURE_SHORTEST = 0.011;   // mm: a probing move needs 0.01 mm
const num MEASURE_BACK = 0.3;         // mm: between the touches of one place
const num MEASURE_SAME = 0.000001;    // mm: places that are one

// What #<_measured_size> is the size of, in #<_measured_size_kind>; 0: of nothing.
const num MEASURE_INSIDE = 1;       // bore, slot
const num MEASURE_OUTSIDE = -1;     // boss, web
const num MEASURE_TOOL_LENGTH = 2;
const num MEASURE_TOOL_RADIUS = 3;
const num MEASURE_PLANE = 4;        // of nothing, but a plane

num measure_mm () {
  return #<_metric> == 1 ? 1 : 1/25.4;
}

// Of the tool in the spindle, in units of the program; $tool_radius and $tool_length are mm.
num measure_radius () {
  return $tool_radius*measure_mm ();
}

num measure_length () {
  return $tool_length*measure_mm ();
}

void measure_settings () {
  IF [EXISTS[#<_measure_travel>] EQ 0] THEN #<_measure_travel>=2000
  IF [EXISTS[#<_measure_fast>] EQ 0] THEN #<_measure_fast>=300
  IF [EXISTS[#<_measure_feed>] EQ 0] THEN #<_measure_feed>=30
  IF [EXISTS[#<_measure_search>] EQ 0] THEN #<_measure_search>=5
  IF [EXISTS[#<_measure_clear>] EQ 0] THEN #<_measure_clear>=2
  IF [EXISTS[#<_measure_within>] EQ 0] THEN #<_measure_within>=0.002
  IF [EXISTS[#<_measure_repeat>] EQ 0] THEN #<_measure_repeat>=5
  IF [EXISTS[#<_measure_wear_max>] EQ 0] THEN #<_measure_wear_max>=0.5
  IF [EXISTS[#<_measured_size_kind>] EQ 0] THEN #<_measured_size_kind>=0
  IF [EXISTS[#<_measured_tool>] EQ 0] THEN #<_measured_tool>=0
}

void measure_here (num place[]) {
  place[0] = $prog_pos[X];
  place[1] = $prog_pos[Y];
  place[2] = $prog_pos[Z];
}

num measure_distance (num one[], num other[]) {
  return hypot (hypot (other[0] - one[0], other[1] - one[1]), other[2] - one[2]);
}

void measure_probed (num place[]) {
  place[0] = $probe[X];
  place[1] = $probe[Y];
  place[2] = $probe[Z];
}

// To a place at the feed between touches. A probe that touches on the way, or has been on before,
// ends the program: U4324 with the place, or E4322. One that touches just at the end of the way is
// found out by the move behind it: `check` takes every probe to do so.
void measure_go (num to_x, num to_y, num to_z) {
  num place[3], to[3] = {to_x, to_y, to_z};
  measure_here (place);
  if (measure_distance (place, to) < MEASURE_SHORTEST*measure_mm ()) { return; }
  G38.3 X=to_x Y=to_y Z=to_z F=#<_measure_travel>*measure_mm ()
  measure_probed (place);
  if ($probe_ok && measure_distance (place, to) > MEASURE_SAME*measure_mm ()) {
    terminate (4324, "the probe touched at X" + str (place[0], 3) + " Y" + str (place[1], 3)
                     + " Z" + str (place[2], 3) + ", on the way between two touches");
  }
  measure_here (place);
  if (measure_distance (place, to) > MEASURE_SHORTEST*measure_mm ()) {
    G38.2 X=to_x Y=to_y Z=to_z F=#<_measure_travel>*measure_mm ()
  }
}

// Back to a place by the way that the probe has come.
void measure_return (num place[]) {
  G0 X=place[0] Y=place[1] Z=place[2]
}

// Whether `check` is at work: there a probe touches just at the end of its way, and leaves just at
// the end of the way back, which no real one does.
bool measure_is_rehearsed (num to[], num back[]) {
  num place[3];
  measure_probed (place);
  if (measure_distance (place, to) > MEASURE_SAME*measure_mm ()) { return false; }
  G38.4 X=back[0] Y=back[1] Z=back[2] F=#<_measure_fast>*measure_mm ()
  measure_probed (place);
  return measure_distance (place, back) < MEASURE_SAME*measure_mm ();
}

// From here towards a place, which lies `beyond` the one where the probe should touch: first fast,
// then slowly again and again until two touches agree; their mean is where the probe stood. Then
// back to where it came from. No touch on the way ends the program by E4320, a probe that is on
// before by E4322, touches that do not agree by U4326. For `check` it touches where it should.
void measure_touch (num to[], num beyond, num touch[]) {
  num from[3], last[3], back[3], count = 0, apart = 0;
  measure_here (from);
  num way = measure_distance (from, to);
  G38.2 X=to[0] Y=to[1] Z=to[2] F=#<_measure_fast>*measure_mm ()
  measure_probed (last);
  num part = min (MEASURE_BACK*measure_mm (), measure_distance (from, last))/way;
  do {
    for (num axis_of = 0; axis_of < 3; axis_of++) {
      back[axis_of] = last[axis_of] - (to[axis_of] - from[axis_of])*part;
    }
    if (count == 0 && measure_is_rehearsed (to, back)) {
      for (num axis_in = 0; axis_in < 3; axis_in++) {
        touch[axis_in] = to[axis_in] - (to[axis_in] - from[axis_in])*beyond/way;
      }
      measure_return (from);
      return;
    }
    measure_return (back);
    G38.2 X=to[0] Y=to[1] Z=to[2] F=#<_measure_feed>*measure_mm ()
    measure_probed (touch);
    apart = measure_distance (touch, last);
    for (num axis_at = 0; axis_at < 3; axis_at++) {
      num now_at = touch[axis_at];
      touch[axis_at] = (touch[axis_at] + last[axis_at])/2;
      last[axis_at] = now_at;
    }
    count += 1;
    if (count > #<_measure_repeat> && apart > #<_measure_within>*measure_mm ()) {
      terminate (4326, "touches of one place are " + str (apart, 4) + " apart");
    }
  } while (count < 2 || apart > #<_measure_within>*measure_mm ());
  measure_return (from);
}

// A face across X or Y that is looked for from the side: `half` from the middle along the direction
// (dir_x, dir_y), from inside outwards or from outside inwards. Returns where the middle of the ball
// stood there, from the middle along the direction. From outside it goes down and up at the side.
num measure_side (num inside, num middle[], num dir_x, num dir_y, num half, num at_z, num safe_z) {
  num begin = inside*measure_radius () + #<_measure_clear>*inside*measure_mm ();
  num from_middle = half - begin;
  if (inside > 0) { from_middle = max (from_middle, 0); }
  num end = half + inside*#<_measure_search>*measure_mm ();
  num begin_x = middle[0] + dir_x*from_middle, begin_y = middle[1] + dir_y*from_middle;
  if (inside < 0) { measure_go (begin_x, begin_y, safe_z); }
  measure_go (begin_x, begin_y, at_z);
  num to[3] = {middle[0] + dir_x*end, middle[1] + dir_y*end, at_z};
  num touch[3];
  measure_touch (to, #<_measure_search>*measure_mm () + measure_radius (), touch);
  if (inside < 0) {
    measure_go (begin_x, begin_y, safe_z);
  } else {
    measure_go (middle[0], middle[1], at_z);
  }
  return (touch[0] - middle[0])*dir_x + (touch[1] - middle[1])*dir_y;
}

// Before a cycle, behind its M73: no results of an earlier one, and the modal state it needs.
void measure_begin () {
  G90 G94
  measure_settings ();
  if (measure_radius () <= 0) {
    terminate (4323, "tool " + str ($tool) + " has no radius: it is not a probe");
  }
  #<_measured_x>=0 #<_measured_y>=0 #<_measured_z>=0
  #<_measured_error_x>=0 #<_measured_error_y>=0 #<_measured_error_z>=0
  #<_measured_size>=0 #<_measured_size_error>=0 #<_measured_size_kind>=0
  #<_measured_angle>=0
  #<_measured_angle_x>=0 #<_measured_angle_y>=0
}

// A length of the report: in mm, as all of it.
string measure_told (string name, num length) {
  return " " + name + "=" + str (length/measure_mm (), 6);
}

// A line of the measurement report (docs/programmer/measuring.md); `values` as measure_told and str
// make them: " size=12.0031".
void measure_report (string feature, string values) {
  log ("measured " + feature + values);
}
