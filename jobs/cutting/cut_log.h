// A turning cut out of a log: tool, speed and power cycle by cycle, depth from the stock that is
// known.
#pragma once

#include <filesystem>
#include <vector>

#include "jobs/cutting/reading_bounds.h"
#include "process/identify/turning_fit.h"

namespace stanok::jobs {

// The workpiece before the cut, in the frame of the program: from this z on to smaller z.
struct StockStep {
  double z_mm = 0.0;
  double radius_mm = 0.0;
};

struct CutLog {
  process::CutRecord record;
  std::vector<double> time_s;  // of each row, from the begin of the log on
};

struct CutLogRequest {
  int channel = 1;
  int spindle = 0;  // of the machine, from 0 on
  std::vector<StockStep> stock;
  ReadingBounds bounds{};
};

// Throws std::runtime_error with what the log lacks.
[[nodiscard]] CutLog read_cut_log(const std::filesystem::path& file, const CutLogRequest& request);

}  // namespace stanok::jobs
