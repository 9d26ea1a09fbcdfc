// MeasurementNotes: what programs have measured since the daemon started, the newest of each
// channel, with numbers that count up: who was away sees what came meanwhile, and whether it is
// all.
//
// Measurements are lines of the log that begin with "measured" (recording/log/measurement_files.h).
// Belongs to the operator server's thread.
#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <map>
#include <nlohmann/json.hpp>

#include "channels/contract/output.h"

namespace stanok::daemon {

class MeasurementNotes {
 public:
  static constexpr std::size_t kept_of_channel = 500;

  // Of another event nothing is kept.
  void take(const channels::Event& event);

  // `channel` 0: of all channels. The answer of `measurement.history`.
  [[nodiscard]] nlohmann::json history(int channel) const;

 private:
  struct OfChannel {
    std::deque<nlohmann::json> newest;
    std::uint64_t count = 0;  // so far
  };
  std::map<int, OfChannel> channels_;
};

}  // namespace stanok::daemon
