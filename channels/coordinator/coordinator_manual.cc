// What operators ask of axes outside of programs: jog and homing.
#include <cmath>

#include "channels/coordinator/coordinator.h"

namespace stanok::channels {
namespace {

std::string_view jog_refusal(std::string_view code) RT_SAFE {
  if (code == "E6006") return "the machine or the drive of the axis is off";
  if (code == "E6008") return "the drive of the axis does not hold it";
  if (code == "E6058")
    return "the scheme of the channel parks the axis: its brake is closed, its drive off; select a "
           "scheme with it";
  if (code == "E6056") return "axes of the channel are being moved by hand";
  if (code == "E6057") return "the axis stands on the limit switch at this end; jog it back";
  if (code == "E6053") return "the axis would leave its travel";
  return "the axis belongs to another channel, or is a spindle now";
}

}  // namespace

Coordinator::Verdict Coordinator::jog(const OperatorEvent& event, Channel* channel) RT_SAFE {
  if (channel == nullptr) return refusal("E6001", "a channel must be named");
  const int axis = channel->axes.named(event.text.view());
  if (axis < 0) return refusal("E6052", "the channel has no axis of that name");
  if (!std::isfinite(event.value) || event.value == 0.0 || !(event.value_2 >= 0.0) ||
      !std::isfinite(event.value_2))
    return refusal("E6054", "a jog needs a velocity that is not 0, and an increment of 0 or more");
  const std::string_view code =
      channel->jog({.axis = axis, .velocity = event.value, .increment = event.value_2});
  return code.empty() ? success() : refusal(code, jog_refusal(code));
}

// Axes that the scheme parks are released for the search and come back to where they are parked.
Coordinator::Verdict Coordinator::step_home(Errand& errand, Channel& target) RT_SAFE {
  constexpr double drives_ready_within_s = 3.0;
  if (errand.stage == 0) {
    if (const auto refused = obstacle(errand, OperatorAction::home, target)) return *refused;
    lang::AxisSet axes = target.motion.axes_to_home();
    if (!errand.text.view().empty()) {
      const int axis = target.axes.named(errand.text.view());
      if (axis < 0) return refusal("E6052", "the channel has no axis of that name");
      axes = static_cast<lang::AxisSet>(axes & 1U << axis);
    }
    target.axes.release(axes);
    if (!target.drives.all_ready()) {
      const double waited = static_cast<double>(errand.cycles) * cycle_s_;
      return waited < drives_ready_within_s
                 ? pending()
                 : refusal("E6008", target, ": the drives are not ready");
    }
    target.home(axes);
    errand.stage = 1;
    return pending();
  }
  if (target.motion.manual().is_active() || target.state().is_ending()) return pending();
  const bool found = target.motion.manual().homing() == ManualMotion::Outcome::succeeded;
  const bool is_overtaken = errand.generation != target.run.generation();
  if (errand.stage == 1 && found && !is_overtaken) {
    target.return_to_parking();
    errand.stage = 2;
    return pending();
  }
  if (target.state().is_powered())
    target.power(Power::on);  // what the scheme parks is braked again
  return found ? success() : refusal("A2001", target.motion.manual().homing_fault().view());
}

}  // namespace stanok::channels
