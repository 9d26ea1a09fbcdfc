// A plunge grinding cycle out of a log: place of the wheel and power of its spindle, cycle by
// cycle.
#pragma once

#include <filesystem>
#include <optional>
#include <vector>

#include "jobs/cutting/reading_bounds.h"
#include "process/identify/grinding_fit.h"

namespace stanok::jobs {

struct GrindLogRequest {
  int channel = 1;
  int spindle = 1;  // of the wheel, of the machine, from 0 on
  double allowance_mm = 0.0;
  // X of the program at which the wheel touches the part; none: the allowance, as the programs of
  // `stanok grind` have it.
  std::optional<double> touch_mm{};
  double watts_per_newton = 0.0;
  ReadingBounds bounds{};
};

struct GrindLog {
  process::GrindRecord record;
  std::vector<double> time_s;  // of each row, from the begin of the log on
};

// The first plunge of the log, from 2 s in front of the touch until the wheel goes back. Throws
// std::runtime_error with what the log lacks.
[[nodiscard]] GrindLog read_grind_log(const std::filesystem::path& file,
                                      const GrindLogRequest& request);

}  // namespace stanok::jobs
