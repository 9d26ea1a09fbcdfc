// Supervision of one drive: requests, plausibility, loss and return of contact.
#include "drives/modbus/axis_exchange.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace stanok::drives {
namespace {

// Weight of a failed exchange in the leaky counter, a good one takes off 1: it falls while 20 % of
// the exchanges fail (0.2 x 3 < 0.8) and rises while 30 % do. Failures that come at random make it
// wander: with 20 % the counter reaches n with the probability x^-n, 0.2 x^4 + 0.8 = x, x = 1.151;
// once in 10^12 polls it reaches 200.
constexpr int failure_weight = 3;
constexpr int leak_max = 200;

// Noise of a velocity estimate, and a drive that overshoots, must not be called absurd.
constexpr double velocity_margin = 2.0;

// Shorter excursions of the following error come from a late target, not from the axis.
constexpr std::chrono::milliseconds following_error_time{100};

// For which a position drive goes on with the velocity of its last target.
constexpr std::chrono::milliseconds bridged_time{100};

double seconds(BusTime time) RT_SAFE {
  return static_cast<double>(time.count()) * 1e-9;
}

}  // namespace

// After a loss contact is back when the polls of one and a half time-outs were answered.
AxisExchange::AxisExchange(const AxisDriveConfig& config, BusTime poll, BusTime timeout)
    : config_(config),
      timeout_(timeout),
      bridging_error_(0.5 * config.acceleration_max * seconds(poll) * seconds(poll)),
      leak_regained_(std::max(0, leak_max - static_cast<int>(3 * timeout / (2 * poll)))) {}

CommandBlock AxisExchange::command(const DriveTarget& target, TargetAge age) RT_SAFE {
  take_offset(target);
  follows_velocity_ = target.mode == OperationMode::cyclic_synchronous_velocity;
  enable_blocked_ = target.enabled && (enable_blocked_ || lost_ || age == TargetAge::stale);
  watch_fault_reset(target);
  const std::optional<Demand> demand = demand_of(target);
  request_ = request_for(target, demand);
  source_ = source_under(request_);

  sent_.control_word = word_for(request_, target.velocity);
  told_reverse_ = has_direction_in_word() && sent_.control_word == config_.words->run_reverse;
  if (target.brake_closed) {
    sent_.control_word |= config_.map.bits.close_brake;
  }
  if (follows_velocity_) {
    sent_.control_word |= config_.map.bits.follow_velocity;
  }
  set_targets(demand, target);
  if (!lost_) {
    const double sent = config_.map.target_velocity.value(sent_.target_velocity);
    const bool actual_is_faster = std::fabs(feedback_.velocity) > std::fabs(sent);
    velocity_before_loss_ = actual_is_faster ? feedback_.velocity : sent;
  }
  ++sent_.heartbeat;
  commanded_ = true;
  return sent_;
}

WriteOrder AxisExchange::write_order() const RT_SAFE {
  return request_ == PowerRequest::on ? WriteOrder::target_first : WriteOrder::control_word_first;
}

std::optional<AxisExchange::Demand> AxisExchange::demand_of(const DriveTarget& target) const
    RT_SAFE {
  const auto position = config_.map.target_position.increments(target.position - position_offset_);
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
  return source_ == TargetSource::actual ? TargetSource::actual : TargetSource::held;
}

// What cannot be sent leaves the targets as they were, without velocity.
void AxisExchange::set_targets(const std::optional<Demand>& demand, const DriveTarget& target)
    RT_SAFE {
  const RegisterField& field = config_.map.target_position;
  const bool follows_cycle = source_ == TargetSource::cycle && demand.has_value();
  if (follows_cycle) {
    sent_.target_position = demand->position;
  } else if (source_ == TargetSource::actual) {
    sent_.target_position = field.saturated_increments(counted_position());
  }
  const double sent = field.exists()  ? field.value(sent_.target_position)
                      : follows_cycle ? target.position - position_offset_
                                      : counted_position();
  target_position_ = sent + position_offset_;
  targets_ = {std::min(targets_.low, sent), std::max(targets_.high, sent)};
  sent_.target_velocity = follows_cycle && !enable_blocked_ ? demand->velocity : 0;
}

std::uint16_t AxisExchange::word_for(PowerRequest request, double velocity) const RT_SAFE {
  return config_.words ? run_word(*config_.words, request, velocity)
                       : control_word(feedback_.state, request);
}

bool AxisExchange::has_direction_in_word() const RT_SAFE {
  return config_.words && config_.words->run_reverse;
}

void AxisExchange::take_offset(const DriveTarget& target) RT_SAFE {
  position_accepted_ = target.position_accepted;
  if (position_accepted_) position_offset_ = target.position_offset;
}

// One demand resets one fault: a fault that comes again stays.
void AxisExchange::watch_fault_reset(const DriveTarget& target) RT_SAFE {
  const bool demanded = target.fault_reset;
  if (demanded && !fault_reset_demanded_) {
    fault_reset_pending_ = true;
  }
  fault_reset_pending_ = fault_reset_pending_ && demanded && feedback_.state == DriveState::fault;
  fault_reset_demanded_ = demanded;
}

PowerRequest AxisExchange::request_for(const DriveTarget& target,
                                       const std::optional<Demand>& demand) const RT_SAFE {
  if (fault_reset_pending_) {
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
      request_ == PowerRequest::on && feedback_.state == DriveState::operation_enabled;
  if (is_taken_over || !moves_axis() || follows_velocity_) return true;
  const double apart = std::fabs(target.position - position_offset_ - counted_position());
  return apart <= config_.following_error_max;
}

std::optional<ExchangeError> AxisExchange::take(const StatusBlock& answer, BusTime asked,
                                                BusTime now) RT_SAFE {
  const auto state = state_in(answer);
  std::optional<ExchangeError> error;
  const bool has_echo = config_.map.heartbeat.exists() && config_.map.heartbeat_echo.exists();
  if (has_echo && commanded_ && answer.heartbeat_echo != sent_.heartbeat) {
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
  if (config_.words) return state_of(*config_.words, answer.status_word, sent_.control_word);
  return state_of(answer.status_word);
}

// A drive that is told its direction by a word reports a speed without sign.
double AxisExchange::velocity_in(const StatusBlock& answer) const RT_SAFE {
  const double velocity = config_.map.velocity.value(answer.velocity);
  return told_reverse_ ? -velocity : velocity;
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
  const double position = config_.map.position.value(answer.position) + position_offset_;
  const double travel = std::fabs(position - feedback_.position);
  const double reach = fastest * seconds(now - feedback_from_) + config_.following_error_max;
  return travel <= reach || !feedback_.valid || position_accepted_;
}

void AxisExchange::accept(const StatusBlock& answer, DriveState state, BusTime asked, BusTime now)
    RT_SAFE {
  const RegisterMap& map = config_.map;
  const double position = map.position.value(answer.position) + position_offset_;
  check_reference(map.position.value(answer.position));
  const bool followed = moves_axis() && source_ == TargetSource::cycle;
  enable_blocked_ |= followed && state != DriveState::operation_enabled;
  answering_ = true;
  commanded_ = false;
  leak_ = std::max(leak_ - 1, 0);
  lost_ = lost_ && leak_ > leak_regained_;
  feedback_.position = position;
  feedback_.target_position = target_position_;
  feedback_.velocity = velocity_in(answer);
  feedback_.fault_code = answer.fault_code;
  feedback_.state = state;
  feedback_.brake_closed = (answer.status_word & map.bits.brake_closed) != 0;
  feedback_.referenced = is_referenced(answer);
  take_measurements(answer);
  feedback_.valid = !lost_;
  ++feedback_.sequence;
  feedback_from_ = asked;
  watch_following_error(map.following_error.value(answer.following_error), now);
  const double sent = target_position_ - position_offset_;
  targets_ = {sent, sent};
}

// A drive without a bit for it knows its position when its encoder is absolute.
bool AxisExchange::is_referenced(const StatusBlock& answer) const RT_SAFE {
  const std::uint16_t bit = config_.map.bits.referenced;
  const bool drive_knows = bit != 0 ? (answer.status_word & bit) != 0 : config_.absolute_encoder;
  return (drive_knows || reference_found_) && !moved_out_of_sight_;
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
  feedback_.position_offset = position_offset_;
  feedback_.index_position = map.index_position.value(answer.index_position) + position_offset_;
  feedback_.index_count = answer.index_count;
}

// Out of sight an axis comes to rest: at most behind the last target that was sent, which may have
// arrived, or, when nothing arrived any more, behind the stretch that it bridges from where it was
// seen last; a velocity drive goes on for the time-out. From there it brakes.
AxisExchange::Band AxisExchange::reach_out_of_sight() const RT_SAFE {
  const double counted = counted_position();
  const double speed = std::fabs(velocity_before_loss_);
  const BusTime bridged = config_.kind == DriveKind::velocity ? timeout_ : bridged_time;
  const double braking =
      config_.acceleration_max > 0.0 ? speed * speed / (2.0 * config_.acceleration_max) : 0.0;
  const double ahead = std::copysign(speed * seconds(bridged), velocity_before_loss_);
  Band reach{std::min({counted, targets_.low, counted + ahead}),
             std::max({counted, targets_.high, counted + ahead})};
  (velocity_before_loss_ < 0.0 ? reach.low : reach.high) += std::copysign(braking, ahead);
  return {reach.low - config_.following_error_max, reach.high + config_.following_error_max};
}

// Further away than it can have moved, the counter of the drive no longer tells the position of the
// machine.
void AxisExchange::check_reference(double counted) RT_SAFE {
  if (position_accepted_) {
    moved_out_of_sight_ = false;
    reference_found_ = true;
  } else if (lost_ && feedback_.sequence > 0 && !follows_velocity_) {
    moved_out_of_sight_ |= counted < reach_.low || counted > reach_.high;
  }
}

// From the nearest target that the drive may be following; 0 while it follows none.
double AxisExchange::deviation() const RT_SAFE {
  const bool follows = source_ == TargetSource::cycle && moves_axis() && !follows_velocity_ &&
                       feedback_.state == DriveState::operation_enabled;
  const double counted = counted_position();
  return follows ? std::clamp(counted, targets_.low, targets_.high) - counted : 0.0;
}

// The worse of what the drive says of itself and what its answer shows.
void AxisExchange::watch_following_error(double reported, BusTime now) RT_SAFE {
  const double seen = deviation();
  feedback_.following_error = std::fabs(seen) > std::fabs(reported) ? seen : reported;
  const double error = follows_velocity_ ? 0.0 : feedback_.following_error;
  if (std::fabs(error) <= config_.following_error_max + bridging_error_) {
    following_error_since_.reset();
  } else if (!following_error_since_) {
    following_error_since_ = now;
  }
  feedback_.following_error_exceeded =
      following_error_since_ && now - *following_error_since_ > following_error_time;
}

std::uint64_t AxisExchange::errors() const RT_SAFE {
  return std::accumulate(errors_.begin(), errors_.end(), std::uint64_t{0});
}

void AxisExchange::fail(ExchangeError error) RT_SAFE {
  ++errors_[error];
  answering_ = false;
  leak_ = std::min(leak_ + failure_weight, leak_max);
}

void AxisExchange::supervise(BusTime now) RT_SAFE {
  const bool silent = now - feedback_from_ > timeout_;
  if (silent || leak_ >= leak_max) lose_contact();
}

void AxisExchange::lose_contact() RT_SAFE {
  if (lost_) return;
  lost_ = true;
  reach_ = reach_out_of_sight();
  leak_ = leak_max;
  feedback_.valid = false;
  ++feedback_.losses;
  // Whether an incremental encoder has counted on meanwhile, or begun anew, nobody can tell.
  reference_found_ = reference_found_ && config_.absolute_encoder;
}

}  // namespace stanok::drives
