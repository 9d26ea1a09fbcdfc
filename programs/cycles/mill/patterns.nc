// Patterns of holes with the drilling cycle that is active: `G81 Z-10 R2 F100 L0`, then the pattern.
//
// The middle of a circle, and the first hole of a line or grid, is where the tool stands. Angles in
// deg from X towards Y.

void hole_refuse_count (num count) {
  if (count < 1 || count != floor (count)) {
    terminate (4402, "a pattern needs a whole number of holes, at least 1");
  }
}

// `count` holes on a circle; `step` is the angle from hole to hole, a part of the circle where it is
// left out.
void hole_circle (num radius, num first_angle, num count, num step = 0) {
  hole_refuse_count (count);
  M73
  G90
  num middle_x = $prog_pos[X], middle_y = $prog_pos[Y], between = step;
  if (step == 0) { between = 360/count; }
  for (num idx = 0; idx < count; idx++) {
    X=middle_x+radius*cos (first_angle + idx*between) Y=middle_y+radius*sin (first_angle + idx*between)
  }
}

// `count` holes on a line, `way` from each other.
void hole_line (num way, num angle, num count) {
  hole_refuse_count (count);
  M73
  G90
  num first_x = $prog_pos[X], first_y = $prog_pos[Y];
  for (num idx = 0; idx < count; idx++) {
    X=first_x+idx*way*cos (angle) Y=first_y+idx*way*sin (angle)
  }
}

// Columns along X and rows along Y, there and back row by row.
void hole_grid (num way_x, num columns, num way_y, num rows) {
  hole_refuse_count (columns);
  hole_refuse_count (rows);
  M73
  G90
  num first_x = $prog_pos[X], first_y = $prog_pos[Y];
  for (num row_idx = 0; row_idx < rows; row_idx++) {
    for (num idx = 0; idx < columns; idx++) {
      num column = idx;
      if (mod (row_idx, 2) == 1) { column = columns - 1 - idx; }
      X=first_x+column*way_x Y=first_y+row_idx*way_y
    }
  }
}
