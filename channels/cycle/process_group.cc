#include "channels/cycle/process_group.h"

#include <cmath>
#include <utility>

namespace stanok::channels {
namespace {

int turning_direction(double speed) RT_SAFE {
  return speed > 0.0 ? 1 : speed < 0.0 ? -1 : 0;
}

}  // namespace

ProcessGroup::ProcessGroup(const ChannelConstants& constants, const AxisGroup& axes,
                           AxisMotion& motion, const SpindleGroup& spindles, ChannelLog& log)
    : constants_(constants), axes_(axes), motion_(motion), spindles_(spindles), log_(log) {
  for (std::size_t k = 0; k < automatic_feeds_max; ++k)
    laws_[k] = motion::AutomaticFeed(constants.automatic_feeds[k]);
}

void ProcessGroup::sense(NumberedSpan<const SpindleSensors> sensors) RT_SAFE {
  const int spindle = constants_.machine_spindle[0];
  if (constants_.spindle_count > 0 && std::cmp_less(spindle, sensors.size()))
    sensors_ = sensors[spindle];
}

double ProcessGroup::form_feed() RT_SAFE {
  const motion::InterpolatorOutput& path = motion_.path();
  const double advanced = path.feed_commanded > 0.0 ? path.path_advanced : 0.0;
  double part = 1.0;
  for (motion::AutomaticFeed& law : laws_) {
    const bool was_lost = law.state() == motion::ModuleState::fault;
    const bool is_modulated = law.config().law == motion::LawKind::modulated;
    law.advance(is_modulated ? sensors_.vibration_um : sensors_.power_w, advanced);
    part *= law.part();
    if (law.state() != motion::ModuleState::fault || was_lost) continue;
    log_.tell("W604",
              is_modulated ? "the vibration sensor gives no value: the feed is at its minimum"
                           : "the power sensor gives no value: the feed is at its minimum",
              path.tag);
  }
  return part;
}

void ProcessGroup::restart_laws() RT_SAFE {
  for (motion::AutomaticFeed& law : laws_) law.restart();
}

bool ProcessGroup::switch_law(motion::LawKind law, Switch to) RT_SAFE {
  for (motion::AutomaticFeed& candidate : laws_) {
    if (candidate.config().law != law) continue;
    to == Switch::on ? candidate.switch_on() : candidate.switch_off();
    return true;
  }
  return false;
}

bool ProcessGroup::command(const motion::ForceCommand& command) RT_SAFE {
  return modifier() != nullptr && modifier()->command(command);
}

motion::ForceEvent ProcessGroup::advance(double feed_override) RT_SAFE {
  if (modifier() == nullptr) return motion::ForceEvent::none;
  demand_ = modifier()->advance(cut_state(feed_override));
  return modifier()->event();
}

motion::CutState ProcessGroup::cut_state(double feed_override) RT_SAFE {
  const motion::InterpolatorOutput& path = motion_.path();
  const Spindle& spindle = spindles_.master();
  const int direction = turning_direction(spindle.target());
  if (direction != 0 && direction != spindle_direction_) ++spindle_starts_;
  spindle_direction_ = direction;
  motion::CutState cut;
  cut.cycle_s = constants_.cycle_s;
  cut.rev_per_min = std::abs(spindle.speed());
  cut.at_speed = spindle.speed() == spindle.target();
  cut.spindle_starts = spindle_starts_;
  if (const int x = motion_.config().geometry[0]; x >= 0) {
    cut.transverse_code = axes_.setpoint(x).position_code;
    cut.transverse_mm = axes_.setpoint(x).position;
    cut.increment_mm = axes_.constants(x).codes.resolution;
    cut.radius_mm = path.point[x].value;
  }
  cut.frame_is_new = motion_.takes_new_frame();
  cut.feed_programmed = path.feed_commanded;
  cut.path_speed = path.s_speed;
  cut.feed_override = feed_override;
  cut.is_rapid = path.s_speed > 0.0 && path.feed_commanded <= 0.0;
  cut.is_controllable = (path.working_axes & geometry_axes()) != 0;
  cut.has_law = path.process.kind != motion::LawKind::none;
  cut.power_w = sensors_.power_w;
  cut.vibration_um = sensors_.vibration_um;
  cut.vibration_hz = sensors_.vibration_hz;
  return cut;
}

unsigned ProcessGroup::geometry_axes() const RT_SAFE {
  unsigned axes = 0;
  for (const int axis : motion_.config().geometry) {
    if (axis >= 0) axes |= 1U << static_cast<unsigned>(axis);
  }
  return axes;
}

void ProcessGroup::apply(motion::FeedControl& control) const RT_SAFE {
  control.controlled_per_s = demand_.feed_per_s;
  control.controlled_max_per_s = demand_.feed_max_per_s;
  control.controlled_axes = geometry_axes();
}

void ProcessGroup::show(ProcessOutput& output) const RT_SAFE {
  for (std::size_t k = 0; k < automatic_feeds_max; ++k) {
    const motion::AutomaticFeed& law = laws_[k];
    output.automatic[k] = {.law = law.config().law, .state = law.state(), .part = law.part()};
  }
  output.has_force_control = has_force_control();
  if (has_force_control()) output.force = modifier()->status();
}

}  // namespace stanok::channels
