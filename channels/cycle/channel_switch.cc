// The switch of kinematics in the cycle: brakes and drives of the axes that leave and join, and
// what remains of it when one of them does not obey.
#include <algorithm>

#include "channels/cycle/channel.h"

namespace stanok::channels {

void Channel::begin_switch(int scheme) RT_SAFE {
  switch_ = Outcome::pending;
  switched_axes_ = 0;
  // Asked for by the own program: the steps of the switch come before the answer.
  if (activity_ == Activity::request) activity_ = Activity::none;
  Notice notice;
  notice.kind = NoticeKind::switch_scheme;
  notice.number = scheme;
  notice.axes_M = axes_M();
  for (std::size_t k = 0; k < motion::axes_max; ++k) {
    if (drives_[k].enabled) notice.enabled = static_cast<lang::AxisSet>(notice.enabled | (1U << k));
  }
  static_cast<void>(link_.notices.push(notice));
}

void Channel::begin_brakes(const Item& item) RT_SAFE {
  double seconds = 0.0;
  for (std::size_t k = 0; k < motion::axes_max; ++k) {
    if ((item.axes >> k & 1U) == 0) continue;
    seconds = std::max(seconds, figures_.axes[k].brake_s + figures_.axes[k].power_s);
    if (item.kind == ItemKind::park_axes) drives_[k].brake_closed = true;
    if (item.kind == ItemKind::join_axes) drives_[k].enabled = true;
  }
  switched_axes_ = static_cast<lang::AxisSet>(switched_axes_ | item.axes);
  wait(Activity::brakes, seconds);
}

// An axis of the step at hand whose brake is not closed or whose drive does not hold it, or -1.
int Channel::disobedient_axis() const RT_SAFE {
  if (drives_are_ideal_) return -1;
  const bool parks = item_.kind == ItemKind::park_axes;
  for (int axis = 0; axis < figures_.axis_count; ++axis) {
    const auto k = static_cast<std::size_t>(axis);
    const bool obeys = parks ? feedback_[k].brake_closed : feedback_[k].enabled;
    if ((item_.axes >> axis & 1U) != 0 && !obeys) return axis;
  }
  return -1;
}

// The scheme stays as it was; what the switch moved stays where it is, braked.
void Channel::fail_switch(int axis) RT_SAFE {
  const bool parks = item_.kind == ItemKind::park_axes;
  ShortText text(parks ? "the brake of axis " : "the drive of axis ");
  text.append(axis_name(axis).view()).append(parks ? " does not close" : " does not switch on");
  text.append("; the scheme is as before, the axes of the change are braked");
  set_axes(switched_axes_, false);
  switch_ = Outcome::failed;
  switch_fault_ = FixedText<8>("E5205");
  text_ = text;
  activity_ = Activity::none;
  running_ ? fail_run("E5205", text.view(), path_.tag) : begin_reset();
}

// By a stop in its middle.
void Channel::end_switch() RT_SAFE {
  set_axes(switched_axes_, false);
  switch_ = Outcome::failed;
  switch_fault_ = FixedText<8>("E6072");
  text_ = ShortText(
      "the change of kinematics was stopped; the scheme is as before, its axes are braked");
}

}  // namespace stanok::channels
