#include "channels/cycle/kinematics_change.h"

#include <algorithm>

namespace stanok::channels {

void KinematicsChange::begin(int scheme) RT_SAFE {
  outcome_ = Outcome::pending;
  changed_ = 0;
  run_.apply(Change::switch_begins);
  link_.tell(
      SchemeSwitch{.scheme = scheme, .axes_M = motion_.axes_M(), .enabled = axes_.enabled()});
}

double KinematicsChange::begin_step(const AxesStep& step) RT_SAFE {
  double seconds = 0.0;
  for (int axis = 0; axis < axes_.count(); ++axis) {
    if ((step.axes >> axis & 1U) == 0) continue;
    const AxisConstants& constants = axes_.constants(axis);
    seconds = std::max(seconds, constants.brake_s + constants.power_s);
  }
  if (step.kind == AxesStep::Kind::park) axes_.close_brakes(step.axes);
  if (step.kind == AxesStep::Kind::join) axes_.switch_on(step.axes);
  changed_ = static_cast<lang::AxisSet>(changed_ | step.axes);
  return seconds;
}

int KinematicsChange::disobedient_axis(const AxesStep& step) const RT_SAFE {
  if (drives_.is_ideal()) return -1;
  const bool parks = step.kind == AxesStep::Kind::park;
  for (int axis = 0; axis < axes_.count(); ++axis) {
    const AxisFeedback& drive = drives_.feedback(axis);
    const bool obeys = parks ? drive.brake_closed : drive.enabled;
    if ((step.axes >> axis & 1U) != 0 && !obeys) return axis;
  }
  return -1;
}

void KinematicsChange::finish_step(const AxesStep& step) RT_SAFE {
  step.kind == AxesStep::Kind::join ? axes_.release(step.axes) : axes_.brake(step.axes);
}

void KinematicsChange::fail(const AxesStep& step, int axis) RT_SAFE {
  const bool parks = step.kind == AxesStep::Kind::park;
  ShortText text(parks ? "the brake of axis " : "the drive of axis ");
  text.append(axes_.name(axis).view()).append(parks ? " does not close" : " does not switch on");
  text.append("; the scheme is unchanged and the axes of the change are braked");
  axes_.brake(changed_);
  refuse("E5205", text.view());
  run_.state().is_running() ? run_.fail("E5205", text.view(), motion_.path().tag)
                            : run_.begin_reset();
}

void KinematicsChange::succeed() RT_SAFE {
  close(Outcome::succeeded);
}

void KinematicsChange::refuse(std::string_view code, std::string_view text) RT_SAFE {
  code_ = FixedText<8>(code);
  text_ = ShortText(text);
  close(Outcome::failed);
}

void KinematicsChange::end() RT_SAFE {
  axes_.brake(changed_);
  refuse("E6072",
         "the change of kinematics was stopped; the scheme is unchanged and its axes are braked");
}

void KinematicsChange::close(Outcome outcome) RT_SAFE {
  outcome_ = outcome;
  run_.apply(Change::switch_ends);
}

}  // namespace stanok::channels
