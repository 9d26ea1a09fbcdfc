// What the virtual workpiece is fed with: the machine file and the cycles of a run, live or
// recorded, in the words of simulation/.
#pragma once

#include <stanok_messages/setpoint_t.hpp>
#include <stanok_messages/workpiece_t.hpp>

#include "channels/contract/output.h"
#include "config/files/machine_file.h"
#include "simulation/workpiece_follower.h"

namespace stanok::runtime {

[[nodiscard]] simulation::ChannelGeometry geometry_of(const channels::MachineConfig& machine,
                                                      const channels::ChannelConfig& channel);
[[nodiscard]] simulation::ToolRecords tools_of(const channels::TablesConfig& tables);
[[nodiscard]] simulation::ToolRecord record_of(const channels::ToolRow& row);
// W in B, of X, Y and Z.
[[nodiscard]] simulation::Pose pose_of(const kinematics::Frame& frame);

// Where a channel stands in one cycle.
[[nodiscard]] simulation::Sample sample_of(const channels::ChannelOutput& output, double time_s);
[[nodiscard]] simulation::Sample sample_of(const setpoint_t& setpoint, double time_s,
                                           const channels::ToolAtWork& tool,
                                           double spindle_rev_per_min);

// What programs have announced so far.
struct WorkpieceNews {
  std::uint32_t announcements = 0;  // of either kind
  std::uint32_t shapes = 0;
  simulation::Announcement blank;
  simulation::Placement placement;
};
[[nodiscard]] WorkpieceNews news_of(const channels::Workpiece& workpiece);
[[nodiscard]] WorkpieceNews news_of(const workpiece_t& message);

// One channel, followed from sample to sample.
class ChannelFeed {
 public:
  ChannelFeed(const channels::MachineConfig& machine, const channels::ChannelConfig& channel,
              std::uint64_t memory_max, simulation::WorkpieceFollower::Complaint complain);

  // `announcements` so far: whether there is news since the last.
  [[nodiscard]] bool has_heard(std::uint32_t announcements) const {
    return announcements == announcements_;
  }
  // Before the sample in which they came; a blank comes before its place.
  void hear(const WorkpieceNews& news, const simulation::Sample& now);
  // Before the sample in which it is at work so; what was known of it, from the table at the
  // beginning of the run or later, is over.
  void hear_of_tool(const channels::ToolRow& row);
  void follow(const simulation::Sample& sample) { follower_.follow(sample); }
  // A cycle with all that it says: tool and workpiece come before the sample.
  void take(const simulation::Sample& sample, const channels::ToolRow& tool,
            const channels::Workpiece& workpiece);

  // From now on these tools are what they really are, whatever rows come.
  void take_real_tools(const std::vector<config::RealTool>& tools);

  // Blanks are taken as fine as the memory allows, where they want to be finer.
  void take_what_fits() { takes_what_fits_ = true; }

  [[nodiscard]] int channel() const { return channel_; }
  [[nodiscard]] simulation::WorkpieceFollower& follower() { return follower_; }

 private:
  int channel_;
  const channels::TablesConfig& tables_;  // at the start of the run
  std::uint64_t memory_max_;
  bool takes_what_fits_ = false;
  simulation::WorkpieceFollower follower_;
  channels::ToolRow tool_row_;                   // that was told last
  std::vector<std::pair<int, int>> real_tools_;  // number and edge: their rows tell nothing
  std::uint32_t announcements_ = 0;
  std::uint32_t shapes_ = 0;
};

}  // namespace stanok::runtime
