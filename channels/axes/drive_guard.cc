#include "channels/axes/drive_guard.h"

#include <cmath>
#include <utility>

namespace stanok::channels {
namespace {

// "the drive of axis X", "the drives of axes X, Y"
struct AxisNames {
  FixedText<64> list;
  int count = 0;

  void add(std::string_view name) RT_SAFE { list.append(count++ == 0 ? "" : ", ").append(name); }
  [[nodiscard]] FixedText<128> sentence(std::string_view of_one, std::string_view of_many) const
      RT_SAFE {
    FixedText<128> text(count == 1 ? "the drive of axis " : "the drives of axes ");
    text.append(list.view()).append(count == 1 ? of_one : of_many);
    return text;
  }
};

}  // namespace

DriveGuard::DriveGuard(const ChannelConstants& constants, const AxisGroup& axes) : axes_(axes) {
  for (std::size_t k = 0; k < motion::axes_max; ++k) {
    feedback_[k].valid = true;
    feedback_[k].enabled = true;
    feedback_[k].referenced = constants.axes[k].homed_at_start;
  }
}

std::optional<Fault> DriveGuard::advance(NumberedSpan<const AxisFeedback> machine,
                                         LimitSwitches limit_switches) RT_SAFE {
  is_ideal_ = machine.empty();
  if (is_ideal_) return std::nullopt;
  all_answer_ = true;
  for (int axis = 0; axis < axes_.count(); ++axis) take(axis, machine[axes_.machine_axis(axis)]);
  const std::optional<Fault> of_drives = fault_of_drives();
  const std::optional<Fault> of_references = fault_of_references(limit_switches);
  const std::optional<Fault> of_switches = fault_of_limit_switches(limit_switches);
  if (of_switches) return of_switches;
  return of_drives ? of_drives : of_references;
}

void DriveGuard::take(int axis, const AxisFeedback& told) RT_SAFE {
  AxisFeedback& drive = feedback_[axis];
  drive = told;
  drive.valid = told.valid && std::isfinite(told.position) && std::isfinite(told.velocity);
  drive.referenced = drive.valid && told.referenced;
  drive.enabled = drive.valid && told.enabled;
  all_answer_ = all_answer_ && drive.valid;
}

std::optional<Fault> DriveGuard::fault_of_drives() RT_SAFE {
  all_ready_ = true;
  AxisNames silent;
  AxisNames faulty;
  AxisNames stray;
  AxisNames released;
  for (int axis = 0; axis < axes_.count(); ++axis) {
    const AxisFeedback& drive = feedback(axis);
    const std::string_view name = axes_.name(axis).view();
    bool& was_ready = was_ready_[axis];
    if (!axes_.drive(axis).enabled || !axes_.owns(axis)) {
      was_ready = false;
      continue;
    }
    all_ready_ = all_ready_ && drive.enabled;
    if (was_ready && !drive.valid) silent.add(name);
    if (was_ready && drive.fault) faulty.add(name);
    if (was_ready && drive.strays) stray.add(name);
    if (was_ready && drive.valid && !drive.enabled && !drive.fault) released.add(name);
    was_ready = was_ready || drive.enabled;
  }
  if (silent.count > 0)
    return Fault{{"A3001"}, silent.sentence(" does not answer", " do not answer")};
  if (faulty.count > 0)
    return Fault{{"A3002"}, faulty.sentence(" reports a fault", " report faults")};
  if (stray.count > 0) {
    return Fault{{"A3003"},
                 stray.sentence(" does not follow its setpoints or report its position",
                                " do not follow their setpoints or report their positions")};
  }
  if (released.count > 0) {
    return Fault{{"A3004"},
                 released.sentence(" has switched itself off", " have switched themselves off")};
  }
  return std::nullopt;
}

// Positions belonged to the machine when it was started; homing takes that back by itself.
std::optional<Fault> DriveGuard::fault_of_references(LimitSwitches switches) RT_SAFE {
  AxisNames lost;
  for (int axis = 0; axis < axes_.count(); ++axis) {
    const AxisFeedback& drive = feedback(axis);
    if (!drive.valid) continue;
    const bool is_led = axes_.drive(axis).enabled && axes_.owns(axis) && !axes_.is_spindle(axis);
    const bool is_homed = is_led && drive.referenced;
    const bool had_it = std::exchange(was_homed_[axis], is_homed);
    if (had_it && is_led && !is_homed && switches == LimitSwitches::stop_the_axis)
      lost.add(axes_.name(axis).view());
  }
  if (lost.count == 0) return std::nullopt;
  return Fault{{"A3005"}, lost.sentence(" has lost its reference", " have lost their references")};
}

std::optional<Fault> DriveGuard::fault_of_limit_switches(LimitSwitches switches) RT_SAFE {
  std::optional<Fault> first;
  for (int axis = 0; axis < axes_.count(); ++axis) {
    const AxisFeedback& drive = feedback(axis);
    const unsigned bit = 1U << axis;
    const bool was_on = (on_limit_switch_ & bit) != 0;
    const bool is_on = drive.valid && (drive.limit_negative || drive.limit_positive);
    on_limit_switch_ =
        static_cast<lang::AxisSet>(is_on ? on_limit_switch_ | bit : on_limit_switch_ & ~bit);
    if (!is_on || was_on || first || switches == LimitSwitches::are_looked_for) continue;
    if (!axes_.drive(axis).enabled) continue;
    first = Fault{{"A2002"}, {"axis "}};
    first->text.append(axes_.name(axis).view())
        .append(drive.limit_negative ? " is on the limit switch at its negative end"
                                     : " is on the limit switch at its positive end");
  }
  return first;
}

int DriveGuard::axis_on_limit_switch() const RT_SAFE {
  for (int axis = 0; axis < axes_.count(); ++axis) {
    if ((on_limit_switch_ >> axis & 1U) != 0) return axis;
  }
  return -1;
}

void DriveGuard::show(ChannelOutput& output) const RT_SAFE {
  output.has_feedback = !is_ideal_;
  output.feedback = feedback_;
}

}  // namespace stanok::channels
