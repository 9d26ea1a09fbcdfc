// Force control of a channel: what its cut looks like to the modifier of the feed, and what becomes
// of what that asks for and tells.
#include <cmath>

#include "channels/cycle/channel.h"

namespace stanok::channels {
namespace {

motion::ForceOrder order_of(const lang::ForceControl& program) RT_SAFE {
  motion::ForceOrder order;
  switch (program.kind) {
    case lang::ForceControl::Kind::off:
      order.kind = motion::ForceOrder::Kind::off;
      break;
    case lang::ForceControl::Kind::force:
      order.kind = motion::ForceOrder::Kind::force;
      break;
    case lang::ForceControl::Kind::oscillate:
      order.kind = motion::ForceOrder::Kind::oscillate;
      break;
    case lang::ForceControl::Kind::vibration_on:
      order.kind = motion::ForceOrder::Kind::vibration_on;
      break;
    case lang::ForceControl::Kind::vibration_off:
      order.kind = motion::ForceOrder::Kind::vibration_off;
      break;
  }
  order.force_n = program.force_n;
  order.feed_min = program.feed_min;
  order.feed_max = program.feed_max;
  order.per_revolution = program.per_revolution;
  order.oscillation_n = program.oscillation_n;
  order.oscillation_hz = program.oscillation_hz;
  order.level_um = program.level_um;
  order.reduced_mass_kg = program.reduced_mass_kg;
  return order;
}

int direction_of(double speed) RT_SAFE {
  return speed > 0.0 ? 1 : speed < 0.0 ? -1 : 0;
}

}  // namespace

void Channel::order_force(const Item& item) RT_SAFE {
  if (!order_force(order_of(item.force)))
    return fail_run("E6062", "the order does not fit the force control at hand", item.tag);
  wait(Activity::spindle, 0.0);
}

bool Channel::order_force(const motion::ForceOrder& order) RT_SAFE {
  motion::FeedModifier* const modifier = figures_.feed_modifier;
  return modifier != nullptr && modifier->order(order);
}

// The cycle that was, as the process sees it; the demand holds for the next one.
void Channel::control_force() RT_SAFE {
  motion::FeedModifier* const modifier = figures_.feed_modifier;
  if (modifier == nullptr) return;
  feed_demand_ = modifier->advance(cut_state());
  frame_is_new_ = false;
  tell_force_event(modifier->event());
}

motion::CutState Channel::cut_state() RT_SAFE {
  motion::CutState cut;
  const Spindle& spindle = spindles_[0];
  const int direction = direction_of(spindle.target());
  if (direction != 0 && direction != spindle_direction_) ++spindle_starts_;
  spindle_direction_ = direction;
  cut.cycle_s = figures_.cycle_s;
  cut.rev_per_min = std::abs(spindle.speed());
  cut.at_speed = spindle.speed() == spindle.target();
  cut.spindle_starts = spindle_starts_;
  const int transverse = motion_.geometry[0];
  if (transverse >= 0) {
    const auto x = static_cast<std::size_t>(transverse);
    cut.transverse_code = setpoints_[x].position_code;
    cut.transverse_mm = setpoints_[x].position;
    cut.discrete_mm = figures_.axes[x].codes.resolution;
    cut.radius_mm = path_.point[x].value;
  }
  cut.frame_is_new = frame_is_new_;
  cut.feed_programmed = path_.feed_commanded;
  cut.path_speed = path_.s_speed;
  cut.feed_override = overrides_.feed_enabled ? control_.feed_override : 1.0;
  cut.is_rapid = path_.s_speed > 0.0 && path_.feed_commanded <= 0.0;
  cut.is_controllable = (path_.working_axes & geometry_axes()) != 0;
  cut.has_law = path_.process.kind != motion::LawKind::none;
  cut.power_w = sensors_.power_w;
  cut.vibration_um = sensors_.vibration_um;
  cut.vibration_hz = sensors_.vibration_hz;
  return cut;
}

unsigned Channel::geometry_axes() const RT_SAFE {
  unsigned axes = 0;
  for (const int axis : motion_.geometry) {
    if (axis >= 0) axes |= 1U << static_cast<unsigned>(axis);
  }
  return axes;
}

void Channel::apply_feed_demand(motion::FeedControl& control) const RT_SAFE {
  control.controlled_per_s = feed_demand_.feed_per_s;
  control.controlled_max_per_s = feed_demand_.feed_max_per_s;
  control.controlled_axes = geometry_axes();
}

void Channel::tell_force_event(motion::ForceEvent event) RT_SAFE {
  using motion::ForceEvent;
  const auto warn = [this](std::string_view code, std::string_view text)
                        RT_SAFE { emit(cycle_, code, text, path_.tag); };
  switch (event) {
    case ForceEvent::none:
      return;
    case ForceEvent::sensor_lost:
      record_alarm("A4010", "the power sensor gives no value: feed hold", path_.tag);
      return hold(HoldCause::sensor_fault);
    case ForceEvent::sensor_lost_slow:
      return record_alarm("A4010", "the power sensor gives no value: the feed is S_min", path_.tag);
    case ForceEvent::sensor_stuck:
      record_alarm("A4011", "the power does not follow the feed: feed hold", path_.tag);
      return hold(HoldCause::sensor_fault);
    case ForceEvent::sensor_stuck_slow:
      return record_alarm("A4011", "the power does not follow the feed: the feed is S_min",
                          path_.tag);
    case ForceEvent::vibration_lost:
      return warn("W611", "the vibration sensor gives no value: no oscillation is formed");
    case ForceEvent::frequency_shifted:
      return warn("W612", "the oscillation would be a multiple of the spindle's: it was shifted");
    case ForceEvent::oscillation_limited:
      return warn("W613", "the force cannot swing as far as asked: the feed would come to rest");
    case ForceEvent::overload_at_feed_min:
      return warn("W614", "the force is above its set-point at S_min");
  }
}

}  // namespace stanok::channels
