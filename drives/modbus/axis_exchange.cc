// Supervision of one drive: requests, plausibility, loss and return of contact.
#include "drives/modbus/axis_exchange.h"

#include <algorithm>
#include <cmath>

namespace stanok::drives {
namespace {

// Noise of a velocity estimate, and a drive that overshoots, must not be called absurd.
constexpr double velocity_margin = 2.0;

double seconds(BusTime time) RT_SAFE {
  return static_cast<double>(time.count()) * 1e-9;
}

}  // namespace

// A late target is seen when it arrives: until then the drive went on with constant velocity for a
// poll.
AxisExchange::AxisExchange(const AxisDriveConfig& config, BusTime poll, BusTime timeout)
    : config_(config),
      contact_(poll, timeout),
      reference_(config.absolute_encoder ? Encoder::absolute : Encoder::incremental),
      following_(config.following_error_max +
                     0.5 * config.target_acceleration_max * seconds(poll) * seconds(poll),
                 config.target_acceleration_max) {}

CommandBlock AxisExchange::command(const DriveTarget& target, TargetAge age) RT_SAFE {
  reference_.take(target);
  follows_velocity_ = target.mode == OperationMode::cyclic_synchronous_velocity;
  enable_blocked_ =
      target.enabled && (enable_blocked_ || contact_.is_lost() || age == TargetAge::stale);
  fault_reset_.look(target, feedback_.state);
  const std::optional<Demand> demand = demand_of(target);
  sent_.request = request_for(target, demand);
  sent_.source = source_under(sent_.request);

  std::uint16_t& word = sent_.block.control_word;
  word = word_for(sent_.request, target.velocity);
  sent_.told_reverse = has_direction_in_word() && word == config_.words->run_reverse;
  if (target.brake_closed) {
    word |= config_.map.bits.close_brake;
  }
  if (follows_velocity_) {
    word |= config_.map.bits.follow_velocity;
  }
  set_targets(demand, target);
  if (!contact_.is_lost()) {
    const double sent = config_.map.target_velocity.value(sent_.block.target_velocity);
    const bool actual_is_faster = std::fabs(feedback_.velocity) > std::fabs(sent);
    velocity_before_loss_ = actual_is_faster ? feedback_.velocity : sent;
  }
  ++sent_.block.heartbeat;
  sent_.awaits_answer = true;
  return sent_.block;
}

WriteOrder AxisExchange::write_order() const RT_SAFE {
  return sent_.request == PowerRequest::on ? WriteOrder::target_first
                                           : WriteOrder::control_word_first;
}

std::optional<AxisExchange::Demand> AxisExchange::demand_of(const DriveTarget& target) const
    RT_SAFE {
  const auto position =
      config_.map.target_position.increments(target.position - reference_.offset());
  const auto velocity = config_.map.target_velocity.increments(
      has_direction_in_word() ? std::fabs(target.velocity) : target.velocity);
  if (!position || !velocity) return std::nullopt;
  return Demand{*position, *velocity};
}

double AxisExchange::counted_position() const RT_SAFE {
  return feedback_.position - feedback_.position_offset;
}

AxisExchange::TargetSource AxisExchange::source_under(PowerRequest request) const RT_SAFE {
  if (!moves_axis()) return TargetSource::cycle;
  if (feedback_.state != DriveState::operation_enabled) return TargetSource::actual;
  if (request == PowerRequest::on) return TargetSource::cycle;
  return sent_.source == TargetSource::actual ? TargetSource::actual : TargetSource::held;
}

// What cannot be sent leaves the targets as they were, without velocity.
void AxisExchange::set_targets(const std::optional<Demand>& demand, const DriveTarget& target)
    RT_SAFE {
  const RegisterField& field = config_.map.target_position;
  const bool follows_cycle = sent_.source == TargetSource::cycle && demand.has_value();
  if (follows_cycle) {
    sent_.block.target_position = demand->position;
  } else if (sent_.source == TargetSource::actual) {
    sent_.block.target_position = field.saturated_increments(counted_position());
  }
  const double sent = field.exists()  ? field.value(sent_.block.target_position)
                      : follows_cycle ? target.position - reference_.offset()
                                      : counted_position();
  sent_.target_position = sent + reference_.offset();
  sent_.targets = {std::min(sent_.targets.low, sent), std::max(sent_.targets.high, sent)};
  sent_.block.target_velocity = follows_cycle && !enable_blocked_ ? demand->velocity : 0;
}

std::uint16_t AxisExchange::word_for(PowerRequest request, double velocity) const RT_SAFE {
  return config_.words ? run_word(*config_.words, request, velocity)
                       : control_word(feedback_.state, request);
}

bool AxisExchange::has_direction_in_word() const RT_SAFE {
  return config_.words && config_.words->run_reverse;
}

PowerRequest AxisExchange::request_for(const DriveTarget& target,
                                       const std::optional<Demand>& demand) const RT_SAFE {
  if (fault_reset_.is_pending()) {
    return PowerRequest::reset_fault;
  }
  if (!target.enabled) {
    return PowerRequest::off;
  }
  if (enable_blocked_ || !demand) {
    return PowerRequest::quick_stop;
  }
  return may_take_over(target) ? PowerRequest::on : PowerRequest::off;
}

// A drive that is to follow the cycle from now on must stand where the cycle has its axis. Once it
// was enabled the cycle may move on, before it is asked the next time.
bool AxisExchange::may_take_over(const DriveTarget& target) const RT_SAFE {
  const bool is_taken_over =
      sent_.request == PowerRequest::on && feedback_.state == DriveState::operation_enabled;
  if (is_taken_over || !moves_axis() || follows_velocity_) return true;
  const double apart = std::fabs(target.position - reference_.offset() - counted_position());
  return apart <= config_.following_error_max;
}

std::optional<ExchangeError> AxisExchange::take(const StatusBlock& answer, BusTime asked,
                                                BusTime now) RT_SAFE {
  const auto state = state_in(answer);
  std::optional<ExchangeError> error;
  const bool has_echo = config_.map.heartbeat.exists() && config_.map.heartbeat_echo.exists();
  if (has_echo && sent_.awaits_answer && answer.heartbeat_echo != sent_.block.heartbeat) {
    error = ExchangeError::stuck;
  } else if (!state || !is_plausible(answer, now)) {
    error = ExchangeError::implausible;
  }
  if (error) {
    fail(*error);
  } else {
    accept(answer, *state, asked, now);
  }
  return error;
}

std::optional<DriveState> AxisExchange::state_in(const StatusBlock& answer) const RT_SAFE {
  if (config_.words) return state_of(*config_.words, answer.status_word, sent_.block.control_word);
  const auto state = state_of(answer.status_word);
  // Of a drive that does tell whether its power stage has voltage.
  const bool has_voltage = (answer.status_word & status::voltage_enabled) != 0;
  const bool holds_axis =
      state == DriveState::operation_enabled && (has_voltage || !has_had_voltage_);
  return state != DriveState::operation_enabled || holds_axis ? state : DriveState::switched_on;
}

// A drive that is told its direction by a word reports a speed without sign.
double AxisExchange::velocity_in(const StatusBlock& answer) const RT_SAFE {
  const double velocity = config_.map.velocity.value(answer.velocity);
  return sent_.told_reverse ? -velocity : velocity;
}

// While contact lasts the axis cannot be further away than it can have travelled. What it did out
// of sight is judged by check_reference.
bool AxisExchange::is_plausible(const StatusBlock& answer, BusTime now) const RT_SAFE {
  if (config_.velocity_max <= 0.0 || follows_velocity_) {
    return true;  // limits and travel are those of the axis, not of the spindle that it is now
  }
  const double fastest = velocity_margin * config_.velocity_max;
  if (std::fabs(velocity_in(answer)) > fastest) {
    return false;
  }
  const double position = config_.map.position.value(answer.position) + reference_.offset();
  const double travel = std::fabs(position - feedback_.position);
  const double reach =
      fastest * seconds(now - contact_.answered_at()) + config_.following_error_max;
  return travel <= reach || !feedback_.valid || reference_.is_accepted();
}

void AxisExchange::accept(const StatusBlock& answer, DriveState state, BusTime asked, BusTime now)
    RT_SAFE {
  const RegisterMap& map = config_.map;
  const double position = map.position.value(answer.position) + reference_.offset();
  check_reference(map.position.value(answer.position));
  has_had_voltage_ = has_had_voltage_ || (answer.status_word & status::voltage_enabled) != 0;
  const bool followed = moves_axis() && sent_.source == TargetSource::cycle;
  enable_blocked_ |= followed && state != DriveState::operation_enabled;
  sent_.awaits_answer = false;
  contact_.note_answer(asked);
  feedback_.position = position;
  feedback_.target_position = sent_.target_position;
  feedback_.velocity = velocity_in(answer);
  feedback_.fault_code = answer.fault_code;
  feedback_.state = state;
  feedback_.brake_closed = (answer.status_word & map.bits.brake_closed) != 0;
  feedback_.referenced = is_referenced(answer);
  take_measurements(answer);
  feedback_.valid = !contact_.is_lost();
  ++feedback_.sequence;
  note_target(asked);
  watch_following_error(map.following_error.value(answer.following_error), now);
  const double sent = sent_.target_position - reference_.offset();
  sent_.targets = {sent, sent};
}

// A drive without a bit for it knows its position when its encoder is absolute.
bool AxisExchange::is_referenced(const StatusBlock& answer) const RT_SAFE {
  const std::uint16_t bit = config_.map.bits.referenced;
  const bool drive_knows = bit != 0 ? (answer.status_word & bit) != 0 : config_.absolute_encoder;
  return (drive_knows || reference_.is_found()) && !reference_.has_moved_out_of_sight();
}

void AxisExchange::take_measurements(const StatusBlock& answer) RT_SAFE {
  const RegisterMap& map = config_.map;
  feedback_.power_w = map.power.value(answer.power);
  feedback_.vibration_um = map.vibration.value(answer.vibration);
  feedback_.vibration_hz = map.vibration_frequency.value(answer.vibration_frequency);
  feedback_.temperature_c = map.temperature.value(answer.temperature);
  feedback_.home_switch = (answer.inputs & map.bits.home_switch) != 0;
  feedback_.limit_negative = (answer.inputs & map.bits.limit_negative) != 0;
  feedback_.limit_positive = (answer.inputs & map.bits.limit_positive) != 0;
  feedback_.position_offset = reference_.offset();
  feedback_.index_position = map.index_position.value(answer.index_position) + reference_.offset();
  feedback_.index_count = answer.index_count;
}

// Out of sight an axis comes to rest: at most behind the last target that was sent, which may have
// arrived, or, when nothing arrived any more, behind the stretch that it bridges from where it was
// seen last; a velocity drive goes on for the time-out. From there it brakes.
Band AxisExchange::reach_out_of_sight() const RT_SAFE {
  const double counted = counted_position();
  const double speed = std::fabs(velocity_before_loss_);
  const double bridged =
      config_.kind == DriveKind::velocity ? seconds(contact_.timeout()) : bridged_s;
  const double braking =
      config_.acceleration_max > 0.0 ? speed * speed / (2.0 * config_.acceleration_max) : 0.0;
  const double ahead = std::copysign(speed * bridged, velocity_before_loss_);
  Band reach{std::min({counted, sent_.targets.low, counted + ahead}),
             std::max({counted, sent_.targets.high, counted + ahead})};
  (velocity_before_loss_ < 0.0 ? reach.low : reach.high) += std::copysign(braking, ahead);
  return {reach.low - config_.following_error_max, reach.high + config_.following_error_max};
}

// Further away than it can have moved, the counter of the drive no longer tells the position of the
// machine.
void AxisExchange::check_reference(double counted) RT_SAFE {
  if (reference_.is_accepted()) {
    reference_.confirm();
  } else if (contact_.is_lost() && feedback_.sequence > 0 && !follows_velocity_) {
    reference_.see_again(counted);
  }
}

bool AxisExchange::follows_targets() const RT_SAFE {
  return sent_.source == TargetSource::cycle && moves_axis() && !follows_velocity_ &&
         feedback_.state == DriveState::operation_enabled;
}

// The velocity that a velocity drive is told is that of the loop in the cycle, which grows with the
// error: it says nothing of where its target ought to be.
void AxisExchange::note_target(BusTime asked) RT_SAFE {
  if (!follows_targets() || config_.kind == DriveKind::velocity) {
    following_.forget_targets();
    return;
  }
  following_.note_target(sent_.target_position - reference_.offset(),
                         config_.map.target_velocity.value(sent_.block.target_velocity), asked);
}

// From the nearest target that the drive may be following; 0 while it follows none.
double AxisExchange::deviation() const RT_SAFE {
  const double counted = counted_position();
  return follows_targets() ? std::clamp(counted, sent_.targets.low, sent_.targets.high) - counted
                           : 0.0;
}

// The worse of what the drive says of itself and what its answer shows.
void AxisExchange::watch_following_error(double reported, BusTime now) RT_SAFE {
  const double seen = deviation();
  feedback_.following_error = std::fabs(seen) > std::fabs(reported) ? seen : reported;
  const double error = follows_velocity_ ? 0.0 : feedback_.following_error;
  feedback_.following_error_exceeded = following_.is_exceeded(error, now);
}

void AxisExchange::fail(ExchangeError error) RT_SAFE {
  contact_.note_failure(error);
}

void AxisExchange::supervise(BusTime now) RT_SAFE {
  if (contact_.is_exhausted(now)) lose_contact();
}

void AxisExchange::lose_contact() RT_SAFE {
  if (contact_.is_lost()) return;
  contact_.lose();
  reference_.lose_sight(reach_out_of_sight());
  feedback_.valid = false;
  ++feedback_.losses;
}

}  // namespace stanok::drives
