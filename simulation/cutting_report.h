// What the cut did, block by block, and what must not happen on a machine.
#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

#include "simulation/blank.h"

namespace stanok::simulation {

// Where in the programs a motion comes from.
struct Origin {
  int channel = 0;
  std::uint32_t run = 0;    // program run of the channel
  std::uint64_t block = 0;  // running number in the run
  std::uint32_t line = 0;   // 0: no program
  std::uint16_t file = 0;   // of the program; 0: its main file

  [[nodiscard]] bool operator==(const Origin&) const = default;
};

enum class FindingKind : std::uint8_t {
  rapid,          // rapid traverse through material
  shank,          // the shank, or what is not ground, in the material
  holder,         // the holder in the material
  spindle_stood,  // a cut without turning spindle
  probe,          // a probe meets the material at rapid traverse
};

// "W921" ..., a row of the catalogue each.
[[nodiscard]] std::string_view code_of(FindingKind kind);
// For people: "a rapid traverse goes through material".
[[nodiscard]] std::string_view text_of(FindingKind kind);

// One for each kind and block.
struct Finding {
  FindingKind kind = FindingKind::rapid;
  Origin origin;
  int tool = 0;
  double time_s = 0.0;              // of the machine, where it begins
  Vector place_K = Vector::Zero();  // of the tip there, in the frame of the blank
  double volume_mm3 = 0.0;
};

struct BlockRemoval {
  Origin origin;
  double volume_mm3 = 0.0;
  double time_s = 0.0;  // in motion

  // Material-removal rate.
  [[nodiscard]] double rate_mm3_per_s() const { return time_s > 0.0 ? volume_mm3 / time_s : 0.0; }
};

class CuttingReport {
 public:
  // Findings below `finding_min_mm3` are rounding.
  explicit CuttingReport(double finding_min_mm3) : finding_min_mm3_(finding_min_mm3) {}

  void add_finding(const Finding& finding);
  void add_removal(const Origin& origin, double volume_mm3);
  void add_time(const Origin& origin, double seconds);

  [[nodiscard]] std::vector<Finding> findings() const;
  // Blocks that removed something, in the order of the run.
  [[nodiscard]] std::vector<BlockRemoval> blocks() const;
  [[nodiscard]] double removed_mm3() const { return removed_mm3_; }

 private:
  [[nodiscard]] BlockRemoval& block_of(const Origin& origin);

  double finding_min_mm3_;
  std::vector<Finding> findings_;
  std::vector<BlockRemoval> blocks_;
  double removed_mm3_ = 0.0;
};

}  // namespace stanok::simulation
