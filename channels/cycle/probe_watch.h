// ProbeWatch: a move that ends where the probe changes (G38.2 to G38.5).
//
// Where that is comes from the drives, in the cycle that sees the change: the place is known to the
// travel of one poll of the bus at the feed of the move (docs/developer/motion.md#probing). Thread:
// the real-time cycle. Owner: the channel.
#pragma once

#include "base/rt_safe.h"
#include "channels/axes/axis_motion.h"
#include "channels/contract/output.h"
#include "channels/cycle/channel_terms.h"
#include "channels/messages/channel_link.h"

namespace stanok::channels {

enum class AtWork : std::uint8_t { probe, other };

class ProbeWatch {
 public:
  // All outlive the watch.
  ProbeWatch(const ChannelConstants& constants, const Signals& inputs, const DriveGuard& drives,
             AxisMotion& motion)
      : constants_(constants), inputs_(inputs), drives_(drives), motion_(motion) {}

  // False: the probe stands already as it should come to stand, which tells nothing about where to
  // go; the move is given up.
  [[nodiscard]] bool begin(const ProbeBegin& probe) RT_SAFE;
  // Once a cycle: what is at work.
  void see_tool(AtWork tool) RT_SAFE;
  // It has begun to touch while axes move for another reason than to find something.
  [[nodiscard]] bool meets_something() const RT_SAFE;
  // Once a cycle, before the path goes on.
  void advance(ChannelLink& link) RT_SAFE;
  [[nodiscard]] bool is_on() const RT_SAFE { return move_.is_on; }
  // What is left of the move is given up: the path comes to rest.
  [[nodiscard]] bool ends_path() const RT_SAFE { return move_.ends_path; }
  // Behind the move.
  [[nodiscard]] ChannelAnswer take_answer() RT_SAFE;
  void end() RT_SAFE { move_ = {}; }

 private:
  struct Move {
    bool is_on = false;          // from the move on until its answer
    int input = -1;              // of it
    bool until_contact = false;  // else until it leaves
    bool has_changed = false;
    bool ends_path = false;
    motion::Point axes_M{};  // where the axes stood when it changed, mm or deg
  };

  // The contact of a probe that is at work; it bounces when it opens.
  struct Contact {
    bool has_closed = false;  // in this cycle
    double open_s = 0.0;
  };

  const ChannelConstants& constants_;
  const Signals& inputs_;
  const DriveGuard& drives_;
  AxisMotion& motion_;
  Move move_;
  Contact contact_;
};

}  // namespace stanok::channels
