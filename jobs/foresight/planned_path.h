// PlannedPath: where a program will lead the tip of a channel, point by point with the lines of the
// program, as it grows.
//
// One thread writes, others read pages that are finished. A page never changes, so that what was
// read stays. Points lie in the active workpiece system W, and on the part (part_place.h), mm; no
// point of the path is further than 0.01 mm from the line between two of them in either system;
// each has the line of the block that leads to it.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "channels/contract/output.h"
#include "jobs/foresight/part_place.h"
#include "recording/format/path_preview.h"

namespace stanok::jobs {

// Why a path does not lead to the end of its program.
enum class GivenUp : std::uint8_t {
  no,
  computing_time,  // it took too long to compute
  machine_time,    // the program takes too long
  points,          // it has too many points
  refused,         // the program does not start
  failed,          // the computation broke off
  replaced,        // something else is looked at
};

struct PathPage {
  struct Point {
    std::array<float, 3> place_mm{};    // in W
    std::array<float, 3> on_part_mm{};  // in P
    std::uint32_t line = 0;
    bool begins = false;  // no line leads to it
    bool rapid = false;
    bool arc = false;              // an arc or a helix leads to it
    float feed_mm_per_min = 0.0F;  // that is asked for on the way to it; 0 in rapid
    std::int32_t tool = 0;
  };
  std::vector<Point> points;
};

class PlannedPath {
 public:
  static constexpr std::size_t page_points = 4096;
  static constexpr std::size_t points_max = 2'000'000;

  PlannedPath(std::uint32_t id, std::string program) : id_(id), program_(std::move(program)) {}

  // Given once, to one path.
  [[nodiscard]] std::uint32_t id() const { return id_; }
  [[nodiscard]] const std::string& program() const { return program_; }

  // Any thread.
  struct State {
    std::size_t pages = 0;
    std::size_t points = 0;
    bool is_complete = false;
    GivenUp given_up = GivenUp::no;
    std::optional<PartSystem> part;  // nothing before the first movement
  };
  [[nodiscard]] State state() const;
  // nullptr: it is not there yet.
  [[nodiscard]] std::shared_ptr<const PathPage> page(std::size_t number) const;

  // The thread that writes. Points beyond the bound are left out; the path is given up then.
  void lie_on(const PartSystem& part);
  void add(const PathPage::Point& point);
  void complete();
  // Unless it is complete, or given up already.
  void give_up(GivenUp why);

 private:
  void finish_page();

  std::uint32_t id_;
  std::string program_;
  PathPage growing_;  // of the thread that writes
  bool is_full_ = false;
  mutable std::mutex mutex_;
  State state_;
  std::vector<std::shared_ptr<const PathPage>> pages_;
};

// Makes the path of one channel from the outputs of all cycles.
class PlannedPathWriter {
 public:
  // X, Y and Z of the channel make the point, and its place on `part`; nothing: no scheme is
  // active.
  PlannedPathWriter(const channels::MachineConfig& machine, const channels::ChannelConfig& channel,
                    const std::optional<PartSystem>& part, std::shared_ptr<PlannedPath> path);
  void add(const channels::ChannelOutput& output);
  void complete();
  [[nodiscard]] const std::shared_ptr<PlannedPath>& path() const { return path_; }

 private:
  enum class Joint { begins, continues };
  struct Place {
    recording::PlotPoint in_W{};
    recording::PlotPoint on_part{};
  };
  // What holds for the way to a point.
  struct Way {
    std::uint32_t line = 0;
    bool rapid = false;
    bool arc = false;
    std::int32_t tool = 0;

    friend bool operator==(const Way&, const Way&) = default;
  };
  [[nodiscard]] static Way way_of(const channels::ChannelOutput& output);
  [[nodiscard]] Place place_of(const channels::ChannelOutput& output);
  [[nodiscard]] recording::PlotPoint on_part(const channels::ChannelOutput& output,
                                             const recording::PlotPoint& in_W) const;
  [[nodiscard]] bool is_elsewhere(const recording::PlotPoint& point) const;
  void put(const Place& place, Joint joint);
  void begin_chord(const Place& place);
  void continue_to(const Place& place);
  [[nodiscard]] bool ends_behind_a_point();
  void end_line();

  std::array<std::optional<std::size_t>, 3> axes_;
  double cycle_s_;
  PartPlace part_place_;
  std::optional<PartSystem> part_;
  std::shared_ptr<PlannedPath> path_;
  // Of the line that grows.
  recording::ChordFilter in_W_;
  recording::ChordFilter on_part_;
  bool is_open_ = false;
  Place last_;
  double last_speed_ = 0.0;  // mm/s
  double speed_ = 0.0;
  Way way_;
  double feed_mm_per_min_ = 0.0;  // laws and force control change it from cycle to cycle
  std::uint32_t run_ = 0;
  std::int32_t scheme_ = 0;
};

}  // namespace stanok::jobs
