#include "channels/preparation/tap_trial.h"

#include <cmath>

#include "channels/axes/spindle_motion.h"
#include "motion/threads/synchronous_run.h"

namespace stanok::channels {
namespace {

// A spindle that turns as it is commanded, at its speed from the first moment on.
class IdealSpindle {
 public:
  IdealSpindle(const SpindleConfig& config, double rev_per_min, double cycle_s)
      : pulses_(config.encoder_pulses), cycle_s_(cycle_s), spindle_(config) {
    spindle_.command(lang::SpindleCommand{.action = lang::SpindleAction::clockwise,
                                          .speed_rev_per_min = rev_per_min});
    while (spindle_.speed() != spindle_.target()) advance();
  }

  void advance() {
    spindle_.advance(cycle_s_);
    observer_.advance(cycle_s_, command_of(spindle_));
    observer_.observe(in_counts(spindle_.angle_deg(), pulses_));
  }
  [[nodiscard]] motion::SpindleMotion coming() const {
    return coming_motion(spindle_, observer_, cycle_s_);
  }
  void obey(const motion::SpindleOrder& order) { channels::obey(spindle_, order); }

 private:
  int pulses_;
  double cycle_s_;
  Spindle spindle_;
  motion::SpindleObserver observer_;
};

}  // namespace

bool TapTrial::succeeds_at(double rev_per_min) const {
  constexpr double trial_max_s = 300.0;
  double length = 0.0;
  for (const motion::Segment& segment : chain.segments) length += segment.length;
  IdealSpindle ideal(spindle, rev_per_min, cycle_s);
  motion::SynchronousRun run(cycle_s);
  run.begin(chain.coupling, length);
  const std::int64_t cycles_max = std::llround(trial_max_s / cycle_s);
  for (std::int64_t n = 0; n < cycles_max && !run.is_over(); ++n) {
    static_cast<void>(run.advance(ideal.coming(), {}));
    if (run.is_lost()) return false;
    ideal.obey(run.order());
    ideal.advance();
  }
  return true;
}

// By halving, as if what goes at a speed went at every lower one; the speed that is returned was
// tried.
double TapTrial::fastest_below(double rev_per_min) const {
  constexpr double near_enough = 1.02;
  constexpr double slowest = 1.0;
  if (rev_per_min <= slowest || !succeeds_at(slowest)) return 0.0;
  double goes = slowest;
  double fails = rev_per_min;
  while (fails > near_enough * goes) {
    const double between = std::floor(std::sqrt(goes * fails));
    if (between <= goes) break;
    (succeeds_at(between) ? goes : fails) = between;
  }
  return goes;
}

}  // namespace stanok::channels
