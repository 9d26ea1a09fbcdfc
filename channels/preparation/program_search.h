// ProgramSearch: where the next run of a channel's program begins, and what lies before that place.
//
// Asked for by an operator, it is carried out twice: at once, to tell what it comes to, and again
// when the program is started, from where the axes stand then. Between both the operator may do
// what he likes. (docs/operator/at-the-machine.md, "Beginning in the middle")
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "channels/preparation/skipped_height.h"
#include "lang/run/block_search.h"
#include "motion/path/path.h"

namespace stanok::kinematics {
class Scheme;
}

namespace stanok::channels {

struct ProgramSearch {
  enum class Stage : std::uint8_t {
    look,   // under way, for the operator
    found,  // waits for the start of the program
    run,    // under way, at the beginning of a run
  };

  lang::StopPlace place;
  bool calculates = true;  // else the run begins with the default modal state
  Stage stage = Stage::look;
  lang::SearchCollector collector;
  SkippedHeight height;
  double feed_mm_min = 0.0;                    // of the last move at feed; 0: there was none
  motion::Point axes_M{};                      // where the axes stand
  const kinematics::Scheme* scheme = nullptr;  // at the place reached so far
};

// Commands that bring the machine, apart from its axes, into the state of a search, in their order.
[[nodiscard]] std::vector<lang::Payload> commands_to_restore(const lang::SearchState& state);

// Bit k: coordinate k differs.
[[nodiscard]] lang::AxisSet axes_apart(const motion::Point& a, const motion::Point& b);

// How the tool comes to where the program goes on: each end of a move, where anything moves.
struct Approach {
  std::optional<motion::Point> lift;     // away from the workpiece, before all else
  std::optional<motion::Point> lateral;  // at that height, rotary axes as well
  std::optional<motion::Point> plunge;   // at feed
};

// Which way leads out of the workpiece, at both ends of an approach: with 1 along its infeed axis.
struct WayOut {
  int infeed = -1;  // an axis whose positive direction leads away from the workpiece; -1: none
  motion::Point at_start{};
  motion::Point at_target{};
};

// From `start` to `target`: out and in along `out`, in one move where that has no axis, and no
// deeper than `height` on the way between.
[[nodiscard]] Approach approach_to(const motion::Point& target, const motion::Point& start,
                                   const WayOut& out, double height);

}  // namespace stanok::channels
