// LoggedTip: where the tip of a channel was on the part, in the order of the messages of its log.
//
// Tools are those of the log (TOOL, TOOL_ROW), and of the machine file until it names one. A log
// does not say whether the spindle of a lathe was an axis: places are those over its bed.
#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <stanok_messages/setpoint_t.hpp>
#include <stanok_messages/tool_row_t.hpp>
#include <stanok_messages/tool_t.hpp>

#include "jobs/foresight/part_place.h"
#include "recording/log/log_reader.h"
#include "simulation/workpiece_follower.h"

namespace stanok::jobs {

class LoggedTip {
 public:
  // `part`: the system of the places.
  LoggedTip(const channels::MachineConfig& machine, const channels::ChannelConfig& channel,
            const PartSystem& part);

  [[nodiscard]] int channel() const { return channel_; }
  // Messages of this channel, before the setpoint from which on they hold.
  void take(const tool_t& message);
  void take(const tool_row_t& message);
  // mm, in P; nothing: the machine does not have the scheme that was active.
  [[nodiscard]] std::optional<simulation::Vector> at(const setpoint_t& setpoint) const;

 private:
  int channel_;
  PartPlace place_;
  PartSystem part_;
  simulation::ToolRecords tools_;
  channels::ToolAtWork tool_;
};

// All setpoints of the tip's channel, in the order of the file, with their places. Nothing is
// returned but the reason why the file cannot be read.
[[nodiscard]] std::optional<recording::LogError> for_each_place(
    const std::filesystem::path& log, LoggedTip& tip,
    const std::function<void(const setpoint_t&, const std::optional<simulation::Vector>&)>& visit);

}  // namespace stanok::jobs
