// A vibration sensor that delivers blocks of samples: its place on the bus, and its new samples.
//
// The module keeps the newest samples in registers: first the count of samples taken so far (16
// bits, overflowing), then `count` samples as 16-bit integers, the oldest first. All of it is read
// in one request each poll, so a block that overlaps the one before loses nothing.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "base/rt_safe.h"

namespace stanok::drives {

struct VibrationSensorConfig {
  static constexpr int count_max = 124;  // with their count one request

  int spindle = 1;
  int unit = 1;
  int first_register = 0;  // of the count; the samples follow
  int count = 100;
  double rate_hz = 4000.0;  // of the samples
  double scale = 10.0;      // increments per um

  // The name that operators use: "S1".
  [[nodiscard]] std::string name() const { return "S" + std::to_string(spindle); }
};

// The new samples of each block, in um.
class VibrationReader {
 public:
  explicit VibrationReader(const VibrationSensorConfig& config);

  // `block`: count and samples as read. The new samples, oldest first, until the next call.
  [[nodiscard]] std::span<const double> take(std::span<const std::uint16_t> block);

  [[nodiscard]] std::uint64_t samples() const { return samples_; }
  // Taken by the sensor, but overwritten before they were read.
  [[nodiscard]] std::uint64_t lost() const { return lost_; }

 private:
  VibrationSensorConfig config_;
  std::vector<double> fresh_;
  std::uint64_t samples_ = 0;
  std::uint64_t lost_ = 0;
  std::uint16_t seen_ = 0;
  bool has_seen_ = false;
};

}  // namespace stanok::drives
