// ThreadLaw: where a chain that a spindle leads is to be, by the angle of the spindle.
//
// In the law s = +-(turns of the spindle - turns at the start); before it a ramp from rest leads
// in, whose time is the angle since its start over the speed that it was made for, and which ends
// half its turns after s = 0. Thread: the cycle. Owner: SynchronousRun, which begins it with what
// RunIn found, or where a tap stands. Invariant: once in the law it stays there.
#pragma once

#include "base/rt_safe.h"
#include "kinematics/jet.h"
#include "motion/profile/profile.h"
#include "motion/threads/spindle_observer.h"

namespace stanok::motion {

// The run-in begins within this cycle.
struct RunInStart {
  double direction = 1.0;  // in which the spindle turns
  double origin = 0.0;     // direction * turns at s = 0
  // The ramp over time, if the spindle kept the speed it had when the ramp began; not empty.
  PhaseRun ramp;
  double ramp_speed = 1.0;
};

class ThreadLaw {
 public:
  void begin(const RunInStart& start) RT_SAFE;
  // Without a run-in: the path stands at `place`, and the spindle brings it back from there when it
  // turns at `out_speed`.
  void begin_at(double place, double turns, double out_speed) RT_SAFE;

  // Where the path is to be at the setpoint, with derivatives by time; once a cycle.
  [[nodiscard]] kinematics::Jet advance(const SpindleMotion& spindle) RT_SAFE;

  // The ramp is over.
  [[nodiscard]] bool is_in_law() const RT_SAFE { return is_in_law_; }
  // s by the law alone.
  [[nodiscard]] double place(const SpindleMotion& spindle) const RT_SAFE {
    return start_.direction * spindle.turns - start_.origin;
  }

 private:
  RunInStart start_;
  bool is_in_law_ = false;
};

}  // namespace stanok::motion
