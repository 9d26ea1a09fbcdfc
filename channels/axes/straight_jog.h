// StraightJog: axes of a channel together along a straight line, by hand: a jog in the directions
// of the tool or of the workpiece.
//
// The line is short of nothing that a jog of one axis has: it keeps the limits of every axis that
// moves, ends where the first of them ends, and lasts as long as it is renewed, or for an
// increment. Axes that are not homed do not move so: their positions say nothing of directions.
// Real-time.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>

#include "base/axis_index.h"
#include "base/rt_safe.h"
#include "channels/axes/manual_axis.h"
#include "channels/contract/output.h"
#include "kinematics/jet.h"
#include "motion/profile/axis_move.h"

namespace stanok::channels {

struct JogLine {
  // What each axis goes for 1 mm of the way, mm or deg; 0: it stays.
  AxisArray<double> direction{};
  double velocity = 0.0;   // along the way, mm/s; its sign is the direction
  double increment = 0.0;  // mm, > 0; 0: while it is renewed
};

class StraightJog {
 public:
  // The spans have the axes of the channel. Returns why not: a code of the catalogue; empty: it
  // goes.
  [[nodiscard]] std::string_view begin(const JogLine& line, std::span<const ManualAxis> axes,
                                       std::span<const AxisFeedback> drives,
                                       std::span<const kinematics::Jet> positions) RT_SAFE;
  // From where they are to `to`, exactly; speed: along the way, 0: that with which each axis
  // searches.
  void go(const AxisArray<double>& to, std::span<const ManualAxis> axes,
          std::span<const kinematics::Jet> positions, double speed) RT_SAFE;
  // Whether the jog under way is this one, which goes on for another lease of so many cycles; the
  // opposite one stops it.
  [[nodiscard]] bool renew(const JogLine& line, std::int64_t cycles) RT_SAFE;
  void lease(std::int64_t cycles) RT_SAFE { cycles_left_ = cycles; }
  void stop() RT_SAFE;

  [[nodiscard]] bool is_active() const RT_SAFE { return is_active_; }
  [[nodiscard]] bool is_leased() const RT_SAFE { return is_active_ && cycles_left_ > 0; }
  // Once a cycle: positions of the axes that are moved are replaced.
  void advance(double cycle_s, std::span<kinematics::Jet> positions) RT_SAFE;

 private:
  AxisArray<double> from_{};
  AxisArray<double> direction_{};
  AxisArray<double> to_{};
  motion::AxisMove move_;          // along the way, from 0
  std::int64_t cycles_left_ = -1;  // of the lease; < 0: no end
  bool is_active_ = false;
  bool has_place_ = false;  // to_ is where it ends unless it is stopped
};

}  // namespace stanok::channels
