// SpeedLimits: what held the speed in each line of a program (`simulate --why`).
//
// Every cycle in which a channel runs a line is counted for one cause: the programmed feed, an
// override, a law, or the axis that uses the largest part of one of its limits; in a curve when the
// path keeps its speed, else while that changes. So that a programmer sees what to change.
#pragma once

#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "channels/contract/machine_config.h"
#include "runtime/simulation.h"

namespace stanok::client {

enum class SpeedCause : std::uint8_t {
  feed,
  feed_override,
  law,
  velocity,
  acceleration,
  jerk,
  transition,  // on the way from one limit to another: none is at its value
  hold,
  standing
};

// One cause, of one axis where it is the limit of an axis.
struct SpeedLimit {
  SpeedCause cause = SpeedCause::feed;
  int axis = -1;  // of the machine
  bool in_curve = false;

  friend auto operator<=>(const SpeedLimit&, const SpeedLimit&) = default;
};

class SpeedLimits final : public runtime::CycleObserver {
 public:
  // `lines`: those asked for, of every channel's own program; empty: all.
  SpeedLimits(const channels::MachineConfig& machine, std::vector<int> lines)
      : machine_(machine), lines_(std::move(lines)) {}

  void observe(const channels::CycleOutput& output) override;

  [[nodiscard]] nlohmann::ordered_json json() const;
  // For people: lines in their order, causes by their time; of all lines those that took longest.
  [[nodiscard]] std::string text() const;

 private:
  struct Line {
    double time_s = 0.0;
    std::map<SpeedLimit, double> causes;  // time, s
  };
  struct Place {
    int channel = 0;
    std::uint16_t file = 0;
    std::uint32_t line = 0;

    friend auto operator<=>(const Place&, const Place&) = default;
  };
  using Causes = std::vector<std::pair<SpeedLimit, double>>;

  [[nodiscard]] bool is_asked(std::uint32_t line) const;
  [[nodiscard]] SpeedLimit limit_of(const channels::ChannelOutput& channel) const;
  [[nodiscard]] SpeedLimit limit_of_axes(const channels::ChannelOutput& channel) const;
  [[nodiscard]] static Causes by_time(const Line& line);
  [[nodiscard]] std::string causes_text(const Line& line) const;
  [[nodiscard]] Line together() const;

  const channels::MachineConfig& machine_;
  std::vector<int> lines_;
  std::map<Place, Line> places_;
  std::map<int, double> speeds_;  // of the path in the cycle before, by channel
};

}  // namespace stanok::client
