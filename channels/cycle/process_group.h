// ProcessGroup: what the sensors of the master spindle make of the feed: laws that are formed in
// the cycle, and force control.
//
// Laws leave a part of the programmed feed; force control asks for another feed. Both act on the
// setpoints of the next cycle. Thread: the real-time cycle. Owner: the channel.
#pragma once

#include <array>
#include <span>

#include "base/numbered.h"
#include "base/rt_safe.h"
#include "channels/axes/axis_motion.h"
#include "channels/axes/spindle_group.h"
#include "channels/cycle/channel_log.h"
#include "channels/cycle/channel_terms.h"
#include "motion/interpolation/automatic_feed.h"
#include "motion/segments/feed_modifier.h"

namespace stanok::channels {

class ProcessGroup {
 public:
  // All outlive the group.
  ProcessGroup(const ChannelConstants& constants, const AxisGroup& axes, AxisMotion& motion,
               const SpindleGroup& spindles, ChannelLog& log);

  // The sensors of all spindles of the machine.
  void sense(NumberedSpan<const SpindleSensors> sensors) RT_SAFE;

  // What the laws of the cycle leave of the programmed feed, by the path at feed of the cycle
  // before.
  [[nodiscard]] double form_feed() RT_SAFE;
  void restart_laws() RT_SAFE;  // a program begins with the programmed feed
  // False: the channel has no such law.
  [[nodiscard]] bool switch_law(motion::LawKind law, Switch to) RT_SAFE;

  [[nodiscard]] bool has_force_control() const RT_SAFE { return modifier() != nullptr; }
  // False: there is no force control, or it does not take the command.
  [[nodiscard]] bool command(const motion::ForceCommand& command) RT_SAFE;
  // The path may go on behind a command or a start of the spindle.
  [[nodiscard]] bool is_ready() const RT_SAFE {
    return modifier() == nullptr || modifier()->is_ready();
  }
  // The cycle that was, as the process sees it. `feed_override`: in force.
  [[nodiscard]] motion::ForceEvent advance(double feed_override) RT_SAFE;
  // What force control asks for in the coming cycle.
  void apply(motion::FeedControl& control) const RT_SAFE;

  void show(ProcessOutput& output) const RT_SAFE;

 private:
  [[nodiscard]] motion::FeedModifier* modifier() const RT_SAFE { return constants_.feed_modifier; }
  [[nodiscard]] motion::CutState cut_state(double feed_override) RT_SAFE;
  [[nodiscard]] unsigned geometry_axes() const RT_SAFE;  // bit k: channel axis k

  const ChannelConstants& constants_;
  const AxisGroup& axes_;
  AxisMotion& motion_;
  const SpindleGroup& spindles_;
  ChannelLog& log_;
  SpindleSensors sensors_;  // of the master spindle
  std::array<motion::AutomaticFeed, automatic_feeds_max> laws_{};
  motion::FeedDemand demand_;
  std::uint32_t spindle_starts_ = 0;
  int spindle_direction_ = 0;
};

}  // namespace stanok::channels
