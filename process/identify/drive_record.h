// The power of a spindle as it was recorded, cycle by cycle.
#pragma once

#include <cstddef>
#include <vector>

namespace stanok::process {

struct DriveRecord {
  double cycle_s = 0.001;
  std::vector<double> rev_per_min{};
  std::vector<double> power_w{};  // as the sensor showed it; not a number: nothing new
  std::vector<bool> cuts{};
  std::vector<double> z_mm{};  // where the cut is; empty: not known
};

// The rows in which the sensor has shown something.
[[nodiscard]] std::vector<std::size_t> reading_rows(const DriveRecord& record);

}  // namespace stanok::process
