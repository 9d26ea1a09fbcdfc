// SkippedHeight: how high the tool was in the part of a program that a block search skips: there it
// may go sideways again.
//
// Points are those of the tip in B. Kept is the box around them, so that any frame can be asked for
// its height: in frames that turn it is an upper bound. Owner: the search.
#pragma once

#include <array>
#include <limits>
#include <optional>

#include "kinematics/scheme.h"
#include "lang/contract/command.h"
#include "motion/path/path.h"

namespace stanok::channels {

class SkippedHeight {
 public:
  // Another tool is in the spindle: nothing is known of it.
  void forget() { box_ = {}; }
  // `geometry`: places of X, Y and Z among the coordinates.
  void pass(const motion::Point& point_B, const std::array<int, 3>& geometry);
  // All that a circle or a curve may reach, from `start_W`.
  void pass(const lang::Move& arc, const motion::Point& start_W, const kinematics::Frame& frame,
            const std::array<int, 3>& geometry);
  void pass(const lang::SplineMove& curve, const motion::Point& start_W,
            const kinematics::Frame& frame, const std::array<int, 3>& geometry);

  // Along coordinate `infeed` of `frame`; nothing: the tool has not moved.
  [[nodiscard]] std::optional<double> along(int infeed, const kinematics::Frame& frame,
                                            const std::array<int, 3>& geometry) const;

 private:
  struct Extent {
    double low = std::numeric_limits<double>::infinity();
    double high = -std::numeric_limits<double>::infinity();
  };
  std::array<Extent, 3> box_{};
};

}  // namespace stanok::channels
