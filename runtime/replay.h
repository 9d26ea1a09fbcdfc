// Replay: a recorded run once more, from its inputs, on the virtual clock; every setpoint is
// compared with the recorded one, bit for bit, and every byte with its check sum
// (docs/operator/replay.md).
//
// The log brings its own machine file, programs, setup and all inputs with their cycles; nothing is
// read from disk but the log.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace stanok::runtime {

// The first setpoint that came out otherwise.
struct SetpointDifference {
  std::int64_t cycle = 0;
  int channel = 0;
  std::string field;  // "position of X"
  double recorded = 0.0;
  double repeated = 0.0;
  std::uint64_t units_in_last_place = 0;  // between both; 0 for what is no double
};

// Cycles, the first and the last one, of which the log has no setpoint: the recorder fell behind.
// They are repeated, for those behind them, and not compared.
struct SetpointGap {
  std::int64_t first = 0;
  std::int64_t last = 0;
};

struct ReplayResult {
  std::int64_t cycles = 0;     // repeated
  std::int64_t setpoints = 0;  // compared
  std::optional<SetpointDifference> difference;
  std::vector<SetpointGap> gaps;
  std::optional<std::int64_t> lost_cycle;  // W720: from this one on it cannot be repeated
  bool is_damaged = false;                 // bytes are not as they were written
  bool is_cut = false;                     // it ends within an event or without its trailer
  bool has_checks = false;                 // every byte is covered; else the setpoints only
  std::vector<std::string> remarks;        // another build, damage, where the log ends

  // The log has no damage, every input, and its end.
  [[nodiscard]] bool is_complete() const { return !lost_cycle && !is_damaged && !is_cut; }
  [[nodiscard]] bool is_same() const { return !difference && is_complete(); }
};

// `progress` is told the part done, 0 to 1, now and then. Throws std::runtime_error when the log
// cannot be read or is not a whole one: what is missing in it is said.
[[nodiscard]] ReplayResult replay(const std::filesystem::path& log,
                                  const std::function<void(double)>& progress);

}  // namespace stanok::runtime
