// Follows one channel of a machine, cycle by cycle: turns the readings of its axes into places of
// the tool over its workpiece, and cuts.
//
// Fed by a simulation as it runs, by a log, or by the bus. Samples that lie on a straight path
// within a part of the resolution are one motion; blocks that are shorter than the steps of the cut
// share one. Not for the real-time cycle.
#pragma once

#include <functional>
#include <optional>
#include <string>

#include "simulation/machine_geometry.h"
#include "simulation/workpiece.h"

namespace stanok::simulation {

// A row of the tool table.
struct ToolRecord {
  ToolShape shape;
  ToolMount mount;
};

// By number and edge.
using ToolRecords = std::map<std::pair<int, int>, ToolRecord>;

// One cycle of the channel.
struct Sample {
  double time_s = 0.0;
  Axes axes_M{};
  int scheme = 0;
  int tool = 0;
  int edge = 1;
  bool rapid = false;
  bool spindle_turns = false;
  Origin origin;
};

// #workpiece: the blank, and the frame W -> B of the program where it is announced.
struct Announcement {
  Blank blank;
  Pose program_in_base = Pose::Identity();
};

// #workpiece_pos: place of the program zero of the blank and Euler angles, intrinsic Z-X'-Z'', in
// the machine system.
struct Placement {
  Vector position = Vector::Zero();
  Vector angles_deg = Vector::Zero();
};

class WorkpieceFollower {
 public:
  // What cannot be followed, said once each: code of the catalogue and text.
  using Complaint = std::function<void(const std::string& code, const std::string& text)>;

  WorkpieceFollower(ChannelGeometry geometry, ToolRecords tools, std::uint64_t memory_max,
                    Complaint complain);

  // Both are in force from the sample that follows; `now` says where the axes stand.
  void announce(const Announcement& announcement, const Sample& now);
  void place(const Placement& placement, const Sample& now);

  // The row of a tool is so from the latest sample on, in the middle of a motion, too.
  void change_tool(int number, int edge, const ToolRecord& record);

  void follow(const Sample& sample);
  // Whether the probe in the spindle touches the workpiece where the axes stand in `now`; false for
  // tools that are no probe. What was followed so far is cut.
  [[nodiscard]] bool touches_workpiece(const Sample& now);
  // A finding of the cut: the probe, which has just met the workpiece in `now`, was at rapid.
  void find_probe_at_rapid(const Sample& now);
  // Whether any tool but an insert touches a disc, which stands in the machine system.
  [[nodiscard]] bool touches(const Sample& now, const Disc& disc_M) const;

  // What was followed so far is cut.
  void flush();
  // Only the workpiece that is being cut stays.
  void forget_former();
  // The one that is being cut; nullptr: none was announced, or the last blank was refused.
  [[nodiscard]] Workpiece* at_work() { return workpiece_; }

  // The scheme on whose base it stands.
  [[nodiscard]] int home() const { return home_; }
  // The workpiece system of its announcement, moved with the blank, in that base.
  [[nodiscard]] Pose program_in_base() const;

  // A rotating tool and where the latest sample has it; nothing: no such tool is at work.
  struct ToolAtWork {
    const MillingTool* tool = nullptr;
    ToolPlace place_K;
  };
  [[nodiscard]] std::optional<ToolAtWork> milling_tool() const;

  // The workpieces of all announcements, in their order; the last one is being cut.
  [[nodiscard]] const std::vector<std::unique_ptr<Workpiece>>& workpieces() const {
    return workpieces_;
  }

 private:
  struct Station {  // of a motion
    ToolPlace place_K;
    double time_s = 0.0;
    Origin origin;  // of the way that leads there
  };
  // Where a probe touched nothing, even wider: it touches nothing within that distance from there,
  // since material does not grow.
  struct FreePlace {
    double distance = 0.0;
    ToolPlace place_K;
  };
  struct ReadyTool {
    std::optional<MillingTool> mill;
    std::optional<TurningTool> insert;
    double reach = 0.0;              // to the top of the flutes
    std::vector<ToolSolid> widened;  // of a probe, by free_distances; else none
    std::optional<FreePlace> free;

    [[nodiscard]] bool probes() const { return !widened.empty(); }
  };

  [[nodiscard]] static bool is_free(const ReadyTool& probe, const ToolPlace& place_K);
  [[nodiscard]] ReadyTool* tool_of(const Sample& sample);
  [[nodiscard]] const ToolRecord* record_of(const Sample& sample) const;
  [[nodiscard]] ReadyTool prepared(const ToolRecord& record) const;
  [[nodiscard]] ToolPlace place_in_base(const Sample& sample) const;
  [[nodiscard]] ToolPlace turning_place(const Sample& sample) const;
  [[nodiscard]] ToolPlace milling_place(const Sample& sample) const;
  [[nodiscard]] Station station_of(const Sample& sample) const;
  [[nodiscard]] bool continues(const Sample& sample) const;
  [[nodiscard]] bool extends_motion(const Station& station) const;
  [[nodiscard]] bool lies_on_the_way(const ToolPlace& end) const;
  [[nodiscard]] std::vector<Share> shares() const;
  void cut(const Station& to);
  // Once of each subject, where it came up first; line 0: nowhere in a program.
  void complain_once(const std::string& code, const std::string& subject, std::uint32_t line);

  MachineGeometry machine_;
  ToolRecords tools_;
  std::uint64_t memory_max_;
  Complaint complain_;
  std::vector<std::string> complaints_;

  std::vector<std::unique_ptr<Workpiece>> workpieces_;
  Workpiece* workpiece_ = nullptr;
  int home_ = 0;                           // scheme on whose base it stands
  Pose blank_in_base_ = Pose::Identity();  // K in B
  Pose base_in_blank_ = Pose::Identity();

  std::map<std::pair<int, int>, ReadyTool> ready_;
  const ReadyTool* tool_ = nullptr;
  std::optional<Sample> latest_;
  std::optional<Station> begin_;
  std::vector<Station> stations_;  // behind it
};

}  // namespace stanok::simulation
