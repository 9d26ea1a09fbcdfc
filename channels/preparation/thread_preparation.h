// ThreadPreparation: G33, rigid taps and the passes of thread cycles, from commands to chains that
// a spindle leads.
//
// Blocks of one spindle that follow each other make one chain, without a stop between; a start
// angle of its own (Q) begins a new one, and so does every tap. Errors are found here, before the
// chain moves: a spindle without an encoder, an axis that is too slow for the lead, a corner too
// sharp for the speed. Owner: the channel's preparation.
#pragma once

#include <optional>
#include <vector>

#include "base/diagnostic.h"
#include "base/expected.h"
#include "channels/contract/held_tap.h"
#include "channels/contract/machine_config.h"
#include "lang/contract/command.h"
#include "motion/threads/thread_builder.h"

namespace stanok::channels {

// Points of a tap that was stopped in its hole.
struct TapWay {
  motion::Point start{};
  motion::Point deepest{};
  motion::Point now{};
  const kinematics::Transform* transform = nullptr;
};

class ThreadPreparation {
 public:
  ThreadPreparation(const MachineConfig& machine, const ChannelConfig& channel,
                    const motion::MotionConfig& motion);

  // No chain is open.
  [[nodiscard]] bool is_empty() const { return builder_.is_empty(); }
  // Whether a move goes on in the open chain.
  [[nodiscard]] bool continues(const lang::SynchronousMove& move) const;

  // Speeds of spindles, for all threads behind.
  void take_spindle(const lang::SpindleCommand& command);
  // G96 and G97 at this position; `x`: its axis that is X, below 0: none.
  void take_cutting_speed(const lang::CuttingSpeedMode& mode, const motion::Point& position, int x);

  // Adds a block from `start`, in a workspace with these axes as X, Y, Z; the first one opens a
  // chain. `line` has its end, tolerance, transform. Or why it cannot be cut.
  [[nodiscard]] std::optional<Diagnostic> add(const lang::SynchronousMove& move,
                                              const motion::PathBlock& line,
                                              const motion::Point& start,
                                              const std::array<int, 3>& geometry);
  // The tap comes out of its hole, in a chain of its own: to where it begins, beside `way.start` as
  // far as it stands beside its way now. Or why it cannot.
  [[nodiscard]] Expected<motion::Point, Diagnostic> take_out(const HeldTap& tap, const TapWay& way,
                                                             const std::array<int, 3>& geometry);
  // Closes the chain.
  [[nodiscard]] motion::ThreadChain finish() { return builder_.finish(); }
  void forget() { builder_.clear(); }

 private:
  struct ThreadSpindle {
    SpindleConfig config;
    double rev_per_min = 0.0;  // commanded; 0: not known
    // Under G96, which gives the speed by the diameter; 0: it does not.
    double cutting_m_per_min = 0.0;
    double limit_rev_per_min = 0.0;  // 0: none

    [[nodiscard]] double speed_at(double diameter_mm) const;
  };

  [[nodiscard]] std::size_t index_of(int spindle) const;
  [[nodiscard]] std::optional<Diagnostic> tried_tap() const;
  [[nodiscard]] std::optional<Diagnostic> refusal(const lang::SynchronousMove& move) const;
  [[nodiscard]] Diagnostic diagnostic_of(const motion::ThreadFault& fault) const;

  const ChannelConfig& channel_;
  motion::ThreadBuilder builder_;
  double cycle_s_;
  std::vector<ThreadSpindle> spindles_;  // in the order of the channel
  std::size_t spindle_ = 0;              // of the open chain
  double rev_per_min_ = 0.0;             // the highest in the open chain
  double start_angle_deg_ = 0.0;
  bool is_tap_ = false;
};

}  // namespace stanok::channels
