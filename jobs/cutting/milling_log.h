// A milling cut out of a log: what the virtual workpiece says of the cut, and power, cycle by
// cycle.
#pragma once

#include <filesystem>
#include <vector>

#include "jobs/cutting/reading_bounds.h"
#include "process/chatter/cutting_process.h"
#include "process/identify/milling_fit.h"
#include "simulation/blank.h"

namespace stanok::jobs {

struct MillingLogRequest {
  int channel = 1;
  int spindle = 0;              // of the machine, from 0 on
  process::CuttingProcess cut;  // teeth and helix of the tool; its forces are not looked at
  int tool = 0;                 // whose cuts are looked at; 0: all
  std::uint64_t memory_max = simulation::memory_default;  // of the virtual workpiece, bytes
  ReadingBounds bounds{};
};

struct MillingLog {
  process::MillingRecord record;
  std::vector<double> time_s;  // of each row, from the begin of the log on
};

// Throws std::runtime_error with what the log lacks.
[[nodiscard]] MillingLog read_milling_log(const std::filesystem::path& file,
                                          const MillingLogRequest& request);

}  // namespace stanok::jobs
