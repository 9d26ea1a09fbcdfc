// RetraceByHand: the way back along a held path and forwards again, for as long as an operator asks
// for it.
//
// Without a length it is a lease, as a jog is: it ends when it is not renewed. Thread: the
// real-time cycle; memory is taken in the constructor. Owner: the axes' motion of a channel.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>

#include "base/rt_safe.h"
#include "channels/contract/operator_command.h"
#include "channels/contract/output.h"
#include "motion/interpolation/interpolator.h"
#include "motion/path/path_history.h"
#include "motion/path/path_queue.h"
#include "motion/retrace/retrace.h"

namespace stanok::channels {

// What is asked of it: by a length, as long as it is renewed (length 0), or as a handwheel turns:
// then what cannot be followed at once is dropped, so that the axes stand soon after the wheel.
struct RetraceOrder {
  enum class Surplus : std::uint8_t { kept, dropped };

  RetraceDirection direction = RetraceDirection::back;
  double length = 0.0;
  Surplus surplus = Surplus::kept;
};

class RetraceByHand {
 public:
  // `history_bytes`: for what was passed; 0: nothing is kept.
  RetraceByHand(const motion::MotionConfig& config, std::size_t history_bytes,
                const kinematics::LengthChanges& lengths)
      : history_(history_bytes), retrace_(config, history_, &lengths), cycle_s_(config.cycle_s) {}

  [[nodiscard]] motion::PathHistory& history() RT_SAFE { return history_; }

  // The path is held here: `way` into its current segment; without one between two chains.
  void leave_path(const motion::Segment* held, double way, const motion::Point& axes_M) RT_SAFE {
    retrace_.begin(held, way, axes_M);
  }
  void end() RT_SAFE { retrace_.end(); }

  // Returns why not: a code of the catalogue; empty: it goes.
  [[nodiscard]] std::string_view go(const RetraceOrder& order) RT_SAFE;
  // As far forwards as where the path is held.
  void return_to_path() RT_SAFE;
  void stop() RT_SAFE { retrace_.stop(); }

  // The axes are led by the retrace, at rest or not.
  [[nodiscard]] bool is_on() const RT_SAFE { return retrace_.is_on(); }
  [[nodiscard]] bool is_moving() const RT_SAFE { return is_on() && !retrace_.is_at_rest(); }
  [[nodiscard]] bool is_leased() const RT_SAFE { return is_moving() && cycles_left_ >= 0; }
  // The lease goes on, or has come to the end of the way, where it is told so.
  [[nodiscard]] bool is_renewed_by(RetraceDirection direction) const RT_SAFE {
    return is_leased() || (is_on() && retrace_.is_at_end(way_of(direction)));
  }
  // They are where the path is held.
  [[nodiscard]] bool is_back() const RT_SAFE {
    return is_on() && !is_moving() && retrace_.is_at_end(motion::RetraceWay::forward);
  }

  // Once a cycle while it is on: sets in `path` where the axes are. Where they are back on the
  // path, that is left as it is.
  void lead(const motion::FeedControl& control, motion::InterpolatorOutput& path) RT_SAFE;
  // What was passed, of a path that is held or not; `current`: the block in which it is, nullptr
  // between chains.
  [[nodiscard]] RetraceState state(const motion::BlockTag* current) const RT_SAFE;

 private:
  [[nodiscard]] static motion::RetraceWay way_of(RetraceDirection direction) RT_SAFE {
    return direction == RetraceDirection::back ? motion::RetraceWay::back
                                               : motion::RetraceWay::forward;
  }

  motion::PathHistory history_;
  motion::Retrace retrace_;
  double cycle_s_;
  std::uint32_t line_ = 0;         // where the axes are
  std::int64_t cycles_left_ = -1;  // of the lease; < 0: none
};

}  // namespace stanok::channels
