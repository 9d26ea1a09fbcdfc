// The programmed path and the axis limits of a workload as files for independent judges.
//
// Path: CSV with the header x,y,z[,b,c],f,g,i,j,stop; the first row is the start point, every other
// row the end of one motion; f in mm/s, g 1 line, 2 and 3 arcs in XY, i and j their centre from the
// start. Limits: JSON with velocity, acceleration and jerk per axis and the path tolerances.
#pragma once

#include <cstdint>
#include <string>

#include "programs/generators/workload.h"

namespace stanok::programs {

// Blocks of a program by running number, from 1.
struct BlockRange {
  std::int64_t first = 1;
  std::int64_t last = std::numeric_limits<std::int64_t>::max();
};

// The motions of the blocks in `range`; the row before the first of them is the start point.
[[nodiscard]] std::string path_csv(const Workload& workload, const BlockRange& range);

[[nodiscard]] std::string limits_json(const Workload& workload);

}  // namespace stanok::programs
