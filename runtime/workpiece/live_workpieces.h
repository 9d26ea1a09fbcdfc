// LiveWorkpieces: the virtual workpieces of a machine that runs, cut while it goes on, for those
// who look at them.
//
// `observe` takes the outputs of all cycles and never waits: what the tools do goes through a ring
// of fixed size to a thread of the idle scheduling class, which cuts. Where that falls behind,
// cycles are left out (the tool then goes straight over them) and counted. Nothing of it leads back
// to the machine. A workpiece is as fine as its blank says, as far as `memory_max` allows, and
// lasts until the next one is announced.
#pragma once

#include <array>
#include <atomic>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "base/ring.h"
#include "runtime/workpiece/workpiece_feed.h"

namespace stanok::runtime {

// What is wanted of the surface: the bricks (simulation/cut_marks.h) from one on that have changed
// behind a version.
struct SurfaceRequest {
  std::uint32_t workpiece = 0;  // that the version is of; 0 or another one: all is wanted
  std::uint32_t since = 0;      // version; 0: all is wanted
  std::size_t from = 0;         // brick
};

struct SurfacePage {
  struct Brick {
    std::size_t number = 0;
    std::size_t first = 0;   // of its corners
    std::size_t behind = 0;  // the last one; the same: there is no surface in it any more
  };
  struct Corner {                     // of a triangle; three each, counter-clockwise from outside
    std::array<float, 3> place_mm{};  // in the workpiece system of the announcement
    int tool = 0;                     // that made the surface there; 0: none did
  };
  std::uint32_t workpiece = 0;  // which announcement of the channel, from 1
  std::uint32_t version = 0;    // what changed later than this page has a later one
  int scheme = 0;               // whose base carries it
  simulation::Pose in_base = simulation::Pose::Identity();  // of that workpiece system
  simulation::Blank blank;
  std::vector<Brick> bricks;
  std::vector<Corner> corners;
  std::optional<std::size_t> next;  // the brick with which the next page begins
  std::uint64_t cycles_left_out = 0;
};

class LiveWorkpieces {
 public:
  static constexpr std::uint64_t memory_max = std::uint64_t{192} << 20;
  static constexpr std::size_t waiting_max = 8192;  // cycles of all channels
  static constexpr std::size_t page_corners = 12'288;

  // Takes a line on what cannot be followed; called from the thread that cuts.
  using ComplaintTaker = std::function<void(const std::string&)>;

  LiveWorkpieces(const channels::MachineConfig& machine, ComplaintTaker complain);
  ~LiveWorkpieces();
  LiveWorkpieces(const LiveWorkpieces&) = delete;
  LiveWorkpieces& operator=(const LiveWorkpieces&) = delete;

  // From one thread.
  void observe(const channels::CycleOutput& output);

  // Nothing: no workpiece is announced there. Waits for the thread that cuts: not for those who
  // must not wait. `request` that begins a series closes a version; its pages share it.
  [[nodiscard]] std::optional<SurfacePage> page(int channel, const SurfaceRequest& request);

 private:
  // A cycle of a channel.
  struct Step {
    std::size_t seat = 0;
    simulation::Sample sample;
    channels::ToolRow tool;
    channels::Workpiece workpiece;
  };
  // A channel with axes.
  struct Seat {
    int channel = 0;
    std::unique_ptr<ChannelFeed> feed;
    std::uint32_t shapes = 0;
    simulation::Workpiece* workpiece = nullptr;
    Step last;  // that was put into the ring, of the thread that observes
  };

  void work(const std::stop_token& stop);
  void give_up(std::string_view reason);
  [[nodiscard]] bool cut_some();
  void cut(const Step& step);
  static void add_brick(const simulation::Workpiece& workpiece, std::size_t brick,
                        SurfacePage& page);

  double cycle_s_;
  ComplaintTaker complain_;
  Ring<Step> steps_{waiting_max};
  std::atomic<std::uint64_t> left_out_{0};
  std::mutex mutex_;  // of what the seats follow
  std::vector<Seat> seats_;
  std::jthread thread_;  // last: it uses the members above
};

}  // namespace stanok::runtime
