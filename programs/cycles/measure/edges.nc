// Edges, corners and planes: where they are, and how they are turned.
//
// Each begins above the corner, or above the first touch, and ends there. An angle is how far the
// part is turned from the axes, in deg, counter-clockwise: #<_measured_angle>.
#include "touch.nc"
#include "features.nc"

// One touch of a face across X (dir_x not 0) or Y, beside (at_x, at_y) on the nominal face.
void measure_edge_point (num at_x, num at_y, num dir_x, num dir_y, num at_z, num safe_z,
                         num touch[]) {
  num before = measure_radius () + #<_measure_clear>*measure_mm ();
  num beyond = #<_measure_search>*measure_mm ();
  measure_go (at_x - dir_x*before, at_y - dir_y*before, safe_z);
  measure_go (at_x - dir_x*before, at_y - dir_y*before, at_z);
  num to[3] = {at_x + dir_x*beyond, at_y + dir_y*beyond, at_z};
  measure_touch (to, beyond + measure_radius (), touch);
  measure_go (at_x - dir_x*before, at_y - dir_y*before, safe_z);
}

// From two places of the ball along an edge that should lie along X (along = 1) or Y to the angle
// by which it is turned; one place twice: 0.
num measure_turn (num one[], num other[], num along) {
  num way_x = other[0] - one[0], way_y = other[1] - one[1];
  if (hypot (way_x, way_y) < MEASURE_SHORTEST*measure_mm ()) { return 0; }
  return along == 1 ? atan (way_y/way_x) : -atan (way_x/way_y);
}

// The edge across X or Y, touched towards `direction` (1 or -1) here and `span` further along it.
void measure_angle (axis across, num direction, num span, num at_z) {
  M73
  measure_begin ();
  num start[3], one[3], other[3];
  measure_here (start);
  num dir_x = across == X ? direction : 0;
  num dir_y = across == X ? 0 : direction;
  num along = across == X ? 0 : 1;
  measure_edge_point (start[0], start[1], dir_x, dir_y, at_z, start[2], one);
  measure_edge_point (start[0] + along*span, start[1] + (1 - along)*span, dir_x, dir_y, at_z,
                      start[2], other);
  measure_go (start[0], start[1], start[2]);
  num angle = measure_turn (one, other, along);
  #<_measured_angle>=angle
  measure_report ("edge", " angle=" + str (angle, 6));
}

// A corner of faces across X and Y, of which the part (outside), or the room (inside), lies on the
// side (side_x, side_y), each 1 or -1. Touched `inset` from the corner along both edges, with `span`
// also there: then the edges may be turned, and the corner is where they meet.
void measure_corner (num inside, num side_x, num side_y, num inset, num span, num at_z) {
  num start[3], one[3], other[3];
  measure_here (start);
  num dir_x = -inside*side_x, dir_y = -inside*side_y;
  num far = inset + span, radius = measure_radius ();
  // The face across X: a line through p with the normal n into the material.
  measure_edge_point (start[0], start[1] + side_y*inset, dir_x, 0, at_z, start[2], one);
  num turn_y = 0;
  if (span > 0) {
    measure_edge_point (start[0], start[1] + side_y*far, dir_x, 0, at_z, start[2], other);
    turn_y = measure_turn (one, other, 0);
  }
  num face_x = dir_x*cos (turn_y), face_y = dir_x*sin (turn_y);
  num face_at = one[0]*face_x + one[1]*face_y + radius;
  // The face across Y.
  measure_edge_point (start[0] + side_x*inset, start[1], 0, dir_y, at_z, start[2], one);
  num turn_x = 0;
  if (span > 0) {
    measure_edge_point (start[0] + side_x*far, start[1], 0, dir_y, at_z, start[2], other);
    turn_x = measure_turn (one, other, 1);
  }
  num other_x = -dir_y*sin (turn_x), other_y = dir_y*cos (turn_x);
  num other_at = one[0]*other_x + one[1]*other_y + radius;
  measure_go (start[0], start[1], start[2]);
  num scale = face_x*other_y - face_y*other_x;
  num corner[3] = {(face_at*other_y - other_at*face_y)/scale, (other_at*face_x - face_at*other_x)/scale, 0};
  measure_keep_middle (corner, start);
  #<_measured_angle>=turn_x
  #<_measured_angle_x>=turn_x
  #<_measured_angle_y>=turn_y
}

void measure_outside_corner (num side_x, num side_y, num inset, num span, num at_z) {
  M73
  measure_begin ();
  measure_corner (MEASURE_OUTSIDE, side_x, side_y, inset, span, at_z);
  measure_report ("outside_corner", measure_told_middle () + " angle="
                  + str (#<_measured_angle>, 6));
}

void measure_inside_corner (num side_x, num side_y, num inset, num span, num at_z) {
  M73
  measure_begin ();
  measure_corner (MEASURE_INSIDE, side_x, side_y, inset, span, at_z);
  measure_report ("inside_corner", measure_told_middle () + " angle="
                  + str (#<_measured_angle>, 6));
}

// The plane of a face that should be at height `face`: touches here, `span_x` along X and `span_y`
// along Y from here. Its normal is #<_measured_normal_x>, .._y, .._z; #<_measured_angle_x> and
// .._angle_y are its slopes along X and Y in deg; #<_measured_z> is its height at the first touch.
void measure_plane (num face, num span_x, num span_y) {
  M73
  measure_begin ();
  num start[3], one[3], two[3], three[3];
  measure_here (start);
  num search = #<_measure_search>*measure_mm ();
  num to[3] = {start[0], start[1], face - search};
  measure_touch (to, search, one);
  measure_go (start[0] + span_x, start[1], start[2]);
  to[0] = start[0] + span_x;
  measure_touch (to, search, two);
  measure_go (start[0], start[1], start[2]);
  measure_go (start[0], start[1] + span_y, start[2]);
  to[0] = start[0];
  to[1] = start[1] + span_y;
  measure_touch (to, search, three);
  measure_go (start[0], start[1], start[2]);
  num slope_x = (two[2] - one[2])/(two[0] - one[0]);
  num slope_y = (three[2] - one[2])/(three[1] - one[1]);
  num steep = hypot (hypot (slope_x, slope_y), 1);
  num normal[3] = {-slope_x/steep, -slope_y/steep, 1/steep};
  num angle_x = atan (slope_x), angle_y = atan (slope_y), height = 0;
  #<_measured_size_kind>=MEASURE_PLANE
  #<_measured_normal_x>=normal[0]
  #<_measured_normal_y>=normal[1]
  #<_measured_normal_z>=normal[2]
  #<_measured_angle_x>=angle_x
  #<_measured_angle_y>=angle_y
  // The ball touches along the normal, beside its lowest point.
  height = one[2] - measure_radius ()*(steep - 1);
  #<_measured_x>=start[0]
  #<_measured_y>=start[1]
  #<_measured_z>=height
  #<_measured_error_z>=height-face
  measure_report ("plane", measure_told ("z", height) + measure_told ("error_z", height - face)
                  + " angle_x=" + str (angle_x, 6) + " angle_y=" + str (angle_y, 6));
}
