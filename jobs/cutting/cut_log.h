// A turning cut out of a log: tool, speed and power cycle by cycle, depth and hardness from the
// stock that is known.
#pragma once

#include <filesystem>
#include <vector>

#include "jobs/cutting/reading_bounds.h"
#include "jobs/cutting/stock_table.h"
#include "process/identify/turning_fit.h"

namespace stanok::jobs {

struct CutLog {
  process::CutRecord record;
  std::vector<double> time_s;  // of each row, from the begin of the log on
};

struct CutLogRequest {
  int channel = 1;
  int spindle = 0;  // of the machine, from 0 on
  StockTable stock;
  ReadingBounds bounds{};
};

// Throws std::runtime_error with what the log lacks.
[[nodiscard]] CutLog read_cut_log(const std::filesystem::path& file, const CutLogRequest& request);

}  // namespace stanok::jobs
