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
#include "channels/contract/reports.h"
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

// A line that is asked for: of a program that was started, or of a file that it calls.
struct AskedLine {
  std::string file;  // its name, with or without folders; empty: the programs themselves
  std::uint32_t line = 0;
};

class SpeedLimits final : public runtime::CycleObserver {
 public:
  // `asked`: the lines told of; empty: all.
  SpeedLimits(const channels::MachineConfig& machine, std::vector<AskedLine> asked)
      : machine_(machine), asked_(std::move(asked)) {}

  void observe(const channels::CycleOutput& output) override;

  // `runs` tell the names of files.
  [[nodiscard]] nlohmann::ordered_json json(const std::vector<channels::RunReport>& runs) const;
  // For people: lines in their order, causes by their time; of all lines those that took longest.
  [[nodiscard]] std::string text(const std::vector<channels::RunReport>& runs) const;

 private:
  struct Line {
    double time_s = 0.0;
    std::map<SpeedLimit, double> causes;  // time, s
  };
  struct Place {
    int channel = 0;
    std::uint32_t run = 0;  // of the channel
    std::uint16_t file = 0;
    std::uint32_t line = 0;

    friend auto operator<=>(const Place&, const Place&) = default;
  };
  // The same for people; of all runs of a program together.
  struct NamedPlace {
    int channel = 0;
    std::string file;
    std::uint32_t line = 0;

    friend auto operator<=>(const NamedPlace&, const NamedPlace&) = default;
  };
  using NamedLines = std::map<NamedPlace, Line>;
  using Causes = std::vector<std::pair<SpeedLimit, double>>;

  static void add(Line& sum, const Line& line);
  [[nodiscard]] NamedLines asked_lines(const std::vector<channels::RunReport>& runs) const;
  [[nodiscard]] bool is_asked(const Place& place, const std::string& file) const;
  [[nodiscard]] SpeedLimit limit_of(const channels::ChannelOutput& channel) const;
  [[nodiscard]] SpeedLimit limit_of_axes(const channels::ChannelOutput& channel) const;
  [[nodiscard]] static Causes by_time(const Line& line);
  [[nodiscard]] std::string causes_text(const Line& line) const;

  const channels::MachineConfig& machine_;
  std::vector<AskedLine> asked_;
  std::map<Place, Line> places_;
  std::map<int, double> speeds_;  // of the path in the cycle before, by channel
};

}  // namespace stanok::client
