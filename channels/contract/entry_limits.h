// EntryLimits: section [entry_limits] of the machine file.
//
// How far values of tools and work offsets may go, and change, before a person has to confirm
// them; programs do not write beyond the limits of values. Lengths mm.
#pragma once

namespace stanok::channels {

struct EntryLimits {
  double touch_off_max = 100.0;  // mm or deg; change of an offset or a length by touching off
  double change_max = 100.0;     // mm or deg; the same by a number, from one that is not 0
  // Of wear or a work offset while a program runs, magnitude, mm or deg.
  double change_in_run_max = 0.5;
  // Along the axis of the tool; across it and of the overhang by the larger magnitude.
  double tool_length_min_mm = 0.0;
  double tool_length_max_mm = 500.0;
  double tool_radius_max_mm = 250.0;
  double wear_max_mm = 2.0;    // magnitude
  double offset_max_mm = 0.0;  // magnitude along a linear axis; 0: by its travel (entry_bounds.h)
};

}  // namespace stanok::channels
