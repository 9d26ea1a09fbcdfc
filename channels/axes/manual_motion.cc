#include "channels/axes/manual_motion.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace stanok::channels {
namespace {

constexpr double drive_answers_s = 3.0;  // when it is told its position
// Home switch and index pulse lie within the travel and a little more; of an axis without limits,
// within this distance.
constexpr double search_reserve = 1.1;
constexpr double search_endless = 800.0;

bool is_limited(const motion::AxisLimits& limits) RT_SAFE {
  return std::isfinite(limits.position_min) && std::isfinite(limits.position_max);
}

double travel(const motion::AxisLimits& limits) RT_SAFE {
  return is_limited(limits) ? search_reserve * (limits.position_max - limits.position_min)
                            : search_endless;
}

motion::RampLimits ramp_of(const motion::AxisLimits& limits) RT_SAFE {
  return {.a = limits.acceleration_max, .j = limits.jerk_max};
}

}  // namespace

void ManualMotion::set_up(std::span<const ManualAxis> axes, double cycle_s) {
  count_ = std::min(axes.size(), axes_.size());
  std::copy_n(axes.begin(), count_, axes_.begin());
  cycle_s_ = cycle_s;
}

std::string_view ManualMotion::jog(const Jog& jog, double from, const AxisFeedback& drive) RT_SAFE {
  AxisState& state = states_[jog.axis];
  const motion::AxisLimits& limits = axes_[jog.axis].limits;
  const bool up = jog.velocity > 0.0;
  if (state.task == Task::jog && state.cycles_left > 0 && jog.increment == 0.0) {
    if (state.move.goes_up() == up) {
      state.cycles_left = std::llround(jog_lease_s / cycle_s_);
      return {};
    }
    state.move.stop();
    state.cycles_left = -1;
  }
  if (jog.increment > 0.0 && takes_up(jog)) return add(jog, drive);
  if (state.task != Task::none || homing_state_ == HomingState::running || line_.is_active())
    return "E6056";
  if (up ? drive.limit_positive : drive.limit_negative) return "E6057";
  double speed = std::min(std::abs(jog.velocity), limits.velocity_max);
  const double way = jog.increment > 0.0 ? jog.increment : travel(limits);
  double to = from + (up ? way : -way);
  if (!drive.referenced) {
    speed = std::min(speed, unreferenced_part * limits.velocity_max);
  } else if (up ? to > limits.position_max : to < limits.position_min) {
    // The end behind the axis does not count: from outside the way in is free.
    const double end = up ? limits.position_max : limits.position_min;
    const bool outward = up ? from >= end : from <= end;
    if (jog.increment > 0.0 || outward) return "E6053";
    to = end;
  }
  state.task = Task::jog;
  state.cycles_left = jog.increment > 0.0 ? -1 : std::llround(jog_lease_s / cycle_s_);
  state.adds = jog.increment > 0.0;
  state.end = to;
  state.more = 0.0;
  state.move.begin(from, to, {.speed = speed, .ramp = ramp_of(limits)});
  return {};
}

double ManualMotion::highest_speed(int axis, const AxisFeedback& drive) const RT_SAFE {
  const double part = drive.referenced ? 1.0 : unreferenced_part;
  return part * axes_[axis].limits.velocity_max;
}

std::string_view ManualMotion::add(const Jog& jog, const AxisFeedback& drive) RT_SAFE {
  AxisState& state = states_[jog.axis];
  const motion::AxisLimits& limits = axes_[jog.axis].limits;
  const bool up = jog.velocity > 0.0;
  const double target = state.end + state.more + (up ? jog.increment : -jog.increment);
  if (up ? drive.limit_positive : drive.limit_negative) return "E6057";
  if (drive.referenced && (up ? target > limits.position_max : target < limits.position_min))
    return "E6053";
  aim_at(state, target, std::min(std::abs(jog.velocity), highest_speed(jog.axis, drive)));
  return {};
}

std::string_view ManualMotion::turn(int axis, double way, double from, const AxisFeedback& drive)
    RT_SAFE {
  AxisState& state = states_[axis];
  const motion::AxisLimits& limits = axes_[axis].limits;
  const double speed = highest_speed(axis, drive);
  Jog jog{.axis = axis, .velocity = std::copysign(speed, way), .increment = std::abs(way)};
  const bool is_under_way = takes_up(jog);
  constexpr double behind_s = 0.1;  // how far a wheel may be ahead of the axis, besides its brake
  const double at = is_under_way ? state.move.position().value : from;
  const double ahead = behind_s * speed + motion::ramp_distance(speed, 0.0, ramp_of(limits));
  const double aimed = is_under_way ? state.end + state.more : from;
  double target = std::clamp(aimed + way, at - ahead, at + ahead);
  // The end of the travel is the end of the wheel's effect; from beyond it the way in is free.
  if (drive.referenced && way > 0.0) target = std::min(target, std::max(at, limits.position_max));
  if (drive.referenced && way < 0.0) target = std::max(target, std::min(at, limits.position_min));
  if (!is_under_way) {
    jog.increment = std::abs(target - from);
    return jog.increment > 0.0 ? this->jog(jog, from, drive) : "E6053";
  }
  if (way > 0.0 ? drive.limit_positive : drive.limit_negative) return "E6057";
  aim_at(state, target, speed);
  return {};
}

// Farther the way that it goes, or to rest first and then back.
void ManualMotion::aim_at(AxisState& state, double target, double speed) RT_SAFE {
  state.speed = speed;
  const bool is_ahead = state.move.goes_up() ? target >= state.end : target <= state.end;
  if (state.more == 0.0 && !state.move.is_at_rest() && is_ahead) {
    state.end = target;
    return state.move.extend(target, speed);
  }
  if (state.more == 0.0) {
    state.move.stop();
    state.end = state.move.end();
  }
  state.more = target - state.end;
}

void ManualMotion::go_on(AxisState& state, const ManualAxis& axis) RT_SAFE {
  const double from = state.end;
  state.end += state.more;
  state.more = 0.0;
  state.move.begin(from, state.end, {.speed = state.speed, .ramp = ramp_of(axis.limits)});
}

std::string_view ManualMotion::jog(const JogLine& line, std::span<const AxisFeedback> drives,
                                   std::span<const kinematics::Jet> positions) RT_SAFE {
  const std::int64_t lease = std::llround(jog_lease_s / cycle_s_);
  if (line_.renew(line, lease)) return {};
  if (is_active()) return "E6056";
  const std::string_view refused =
      line_.begin(line, {axes_.begin(), axes_.begin() + count_}, drives, positions);
  if (refused.empty() && line.increment == 0.0) line_.lease(lease);
  return refused;
}

void ManualMotion::go(int axis, double from, double to) RT_SAFE {
  const ManualAxis& constants = axes_[axis];
  AxisState& state = states_[axis];
  state.task = Task::jog;
  state.adds = false;
  state.cycles_left = -1;
  state.move.begin(from, to, {.speed = search_speed(constants), .ramp = ramp_of(constants.limits)});
}

void ManualMotion::go(const AxisArray<double>& to, std::span<const kinematics::Jet> positions,
                      double speed) RT_SAFE {
  line_.go(to, {axes_.begin(), axes_.begin() + count_}, positions, speed);
}

void ManualMotion::home(lang::AxisSet axes) RT_SAFE {
  to_home_ = 0;
  for (std::size_t k = 0; k < count_; ++k) {
    if ((axes >> k & 1U) != 0 && axes_[k].homing.order > 0)
      to_home_ = static_cast<lang::AxisSet>(to_home_ | 1U << k);
  }
  fault_ = {};
  homing_state_ = to_home_ == 0 ? HomingState::succeeded : HomingState::running;
}

void ManualMotion::stop() RT_SAFE {
  if (homing_state_ == HomingState::running) {
    homing_state_ = HomingState::failed;
    fault_ = FixedText<128>("homing was stopped");
  }
  to_home_ = 0;
  line_.stop();
  for (AxisState& state : states_) {
    state.move.stop();
    state.adds = false;
    state.more = 0.0;
    state.reference.accepted = false;
    // An axis that waits for its drive stands where it is.
    state.task = state.task == Task::jog || state.task == Task::search ? Task::jog : Task::none;
    state.cycles_left = -1;
  }
}

void ManualMotion::break_off() RT_SAFE {
  stop();
  line_ = {};
  for (AxisState& state : states_) state.task = Task::none;
}

bool ManualMotion::is_active() const RT_SAFE {
  return to_home_ != 0 || line_.is_active() ||
         std::any_of(states_.begin(), states_.end(),
                     [](const AxisState& state) { return state.task != Task::none; });
}

bool ManualMotion::takes_up(const Jog& jog) const RT_SAFE {
  const AxisState& state = states_[jog.axis];
  return jog.increment > 0.0 ? state.task == Task::jog && state.adds : jogs(jog.axis);
}

bool ManualMotion::jogs(int axis) const RT_SAFE {
  return axis >= 0 && states_[axis].task == Task::jog && states_[axis].cycles_left > 0;
}

bool ManualMotion::is_jogging() const RT_SAFE {
  for (int axis = 0; axis < static_cast<int>(count_); ++axis)
    if (jogs(axis)) return true;
  return jogs_along_line();
}

void ManualMotion::advance(std::span<const AxisFeedback> drives,
                           std::span<kinematics::Jet> positions) RT_SAFE {
  line_.advance(cycle_s_, positions);
  bool searches = false;
  for (std::size_t k = 0; k < count_; ++k) {
    AxisState& state = states_[k];
    switch (state.task) {
      case Task::none:
        break;
      case Task::jog:
        if (state.cycles_left == 1) state.move.stop();
        if (state.cycles_left > 0) --state.cycles_left;
        run(state, positions[k]);
        if (!state.move.is_at_rest()) break;
        if (state.more != 0.0) {
          go_on(state, axes_[k]);
        } else {
          state.task = Task::none;
        }
        break;
      case Task::search:
        search(k, drives[k], positions[k]);
        break;
      case Task::accept:
        accept(k, drives[k], positions[k]);
        break;
    }
    searches = searches || state.task == Task::search || state.task == Task::accept;
  }
  if (homing_state_ == HomingState::running && !searches) begin_next_order(positions);
}

// The axes of the lowest order of those that are left; none: homing is done.
void ManualMotion::begin_next_order(std::span<const kinematics::Jet> positions) RT_SAFE {
  int order = std::numeric_limits<int>::max();
  for (std::size_t k = 0; k < count_; ++k) {
    if ((to_home_ >> k & 1U) != 0) order = std::min(order, axes_[k].homing.order);
  }
  if (to_home_ == 0) homing_state_ = HomingState::succeeded;
  for (std::size_t k = 0; k < count_; ++k) {
    const ManualAxis& axis = axes_[k];
    if ((to_home_ >> k & 1U) == 0 || axis.homing.order != order) continue;
    to_home_ = static_cast<lang::AxisSet>(to_home_ & ~(1U << k));
    AxisState& state = states_[k];
    const double at = positions[k].value;
    const motion::RampLimits ramp = ramp_of(axis.limits);
    state.move.begin(at, at, {.speed = axis.limits.velocity_max, .ramp = ramp});
    state.homing.begin(axis.homing, ramp, travel(axis.limits));
    state.task = Task::search;
  }
}

void ManualMotion::search(std::size_t axis, const AxisFeedback& drive, kinematics::Jet& position)
    RT_SAFE {
  AxisState& state = states_[axis];
  const AxisHoming::Result result = state.homing.advance(drive, state.move);
  if (result == AxisHoming::Result::failed) return fail(axis, state.homing.reason());
  run(state, position);
  if (result == AxisHoming::Result::running) return;
  const double shift = axes_[axis].homing.position - state.homing.home();
  state.reference = {.accepted = true, .offset = drive.position_offset + shift};
  position.value += shift;
  state.task = Task::accept;
  state.cycles_left = std::llround(drive_answers_s / cycle_s_);
}

// Until the drive speaks of the machine's positions.
void ManualMotion::accept(std::size_t axis, const AxisFeedback& drive,
                          const kinematics::Jet& position) RT_SAFE {
  AxisState& state = states_[axis];
  const double away = std::max(std::abs(drive.position - position.value),
                               std::abs(drive.setpoint - position.value));
  if (drive.valid && drive.referenced && away <= axes_[axis].following_error_max) {
    state.reference.accepted = false;
    state.task = Task::none;
  } else if (--state.cycles_left <= 0) {
    fail(axis, "the drive does not accept its position");
  }
}

void ManualMotion::run(AxisState& state, kinematics::Jet& position) RT_SAFE {
  state.move.advance(cycle_s_);
  position = state.move.position();
}

void ManualMotion::fail(std::size_t axis, std::string_view reason) RT_SAFE {
  stop();
  homing_state_ = HomingState::failed;
  fault_ = FixedText<128>("axis ");
  fault_.append(axes_[axis].name.view()).append(": ").append(reason);
}

}  // namespace stanok::channels
