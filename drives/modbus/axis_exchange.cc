// Supervision of one drive: requests, plausibility, loss and return of contact.
#include "drives/modbus/axis_exchange.h"

#include <algorithm>
#include <cmath>

namespace stanok::drives {
namespace {

// Weight of a failed exchange in the leaky counter, a good one takes off 1: 20 % of failures are
// borne for ever (0.2 x 3 < 0.8), 30 % are not.
constexpr int failure_weight = 3;

// Noise of a velocity estimate, and a drive that overshoots, must not be called absurd.
constexpr double velocity_margin = 2.0;

// Shorter excursions of the following error come from a late target, not from the axis.
constexpr std::chrono::milliseconds following_error_time{100};

double seconds(BusTime time) RT_SAFE {
  return static_cast<double>(time.count()) * 1e-9;
}

}  // namespace

// The counter is full when every exchange of `timeout` has failed.
AxisExchange::AxisExchange(const AxisDriveConfig& config, BusTime poll, BusTime timeout)
    : config_(config),
      timeout_(timeout),
      leak_max_(failure_weight * std::max(1, static_cast<int>(timeout / poll))) {}

CommandBlock AxisExchange::command(const DriveTarget& target, TargetAge age) RT_SAFE {
  const auto position = increments(target.position, config_.position_scale);
  const auto velocity = increments(target.velocity, config_.velocity_scale);
  const bool sendable = position && velocity;
  enable_blocked_ = target.enabled && (enable_blocked_ || lost_ || age == TargetAge::stale);
  position_accepted_ = target.position_accepted;
  watch_fault_reset(target.fault_reset);

  sent_.control_word = control_word(feedback_.state, request_for(target, sendable));
  if (target.brake_closed) {
    sent_.control_word |= control::close_brake;
  }
  follows_velocity_ = target.mode == OperationMode::cyclic_synchronous_velocity;
  if (follows_velocity_) {
    sent_.control_word |= control::follow_velocity;
  }
  if (sendable) {
    sent_.target_position = *position;
  }
  sent_.target_velocity = sendable && !enable_blocked_ ? *velocity : 0;
  if (!lost_) {
    speed_before_loss_ = std::max(std::fabs(feedback_.velocity),
                                  std::fabs(sent_.target_velocity / config_.velocity_scale));
  }
  ++sent_.heartbeat;
  return sent_;
}

// One demand resets one fault: a fault that comes again stays.
void AxisExchange::watch_fault_reset(bool demanded) RT_SAFE {
  if (demanded && !fault_reset_demanded_) {
    fault_reset_pending_ = true;
  }
  fault_reset_pending_ = fault_reset_pending_ && demanded && feedback_.state == DriveState::fault;
  fault_reset_demanded_ = demanded;
}

PowerRequest AxisExchange::request_for(const DriveTarget& target, bool sendable) const RT_SAFE {
  if (fault_reset_pending_) {
    return PowerRequest::reset_fault;
  }
  if (!target.enabled) {
    return PowerRequest::off;
  }
  return enable_blocked_ || !sendable ? PowerRequest::quick_stop : PowerRequest::on;
}

std::optional<ExchangeError> AxisExchange::take(const StatusBlock& answer, BusTime asked,
                                                BusTime now) RT_SAFE {
  const auto state = state_of(answer.status_word);
  std::optional<ExchangeError> error;
  if (answer.heartbeat_echo != sent_.heartbeat) {
    error = ExchangeError::stuck;
  } else if (!state || !is_plausible(answer, now)) {
    error = ExchangeError::implausible;
  }
  if (error) {
    fail();
  } else {
    accept(answer, *state, asked, now);
  }
  return error;
}

// While contact lasts the axis cannot be further away than it can have travelled. What it did out
// of sight is judged by check_reference.
bool AxisExchange::is_plausible(const StatusBlock& answer, BusTime now) const RT_SAFE {
  if (config_.velocity_max <= 0.0 || follows_velocity_) {
    return true;  // limits and travel are those of the axis, not of the spindle that it is now
  }
  const double fastest = velocity_margin * config_.velocity_max;
  if (std::fabs(answer.velocity / config_.velocity_scale) > fastest) {
    return false;
  }
  const double travel = std::fabs(answer.position / config_.position_scale - feedback_.position);
  const double reach = fastest * seconds(now - feedback_from_) + config_.following_error_max;
  return travel <= reach || !feedback_.valid || position_accepted_;
}

void AxisExchange::accept(const StatusBlock& answer, DriveState state, BusTime asked, BusTime now)
    RT_SAFE {
  const double position = answer.position / config_.position_scale;
  check_reference(position, now);
  answering_ = true;
  leak_ = std::max(leak_ - 1, 0);
  lost_ = lost_ && leak_ > leak_max_ / 2;
  feedback_.position = position;
  feedback_.target_position = sent_.target_position / config_.position_scale;
  feedback_.velocity = answer.velocity / config_.velocity_scale;
  feedback_.following_error = answer.following_error / config_.position_scale;
  feedback_.power_w = answer.power_w;
  feedback_.vibration_um = answer.vibration * 0.1;
  feedback_.vibration_hz = answer.vibration_frequency * 0.1;
  feedback_.fault_code = answer.fault_code;
  feedback_.state = state;
  feedback_.brake_closed = (answer.status_word & status::brake_closed) != 0;
  feedback_.referenced = (answer.status_word & status::referenced) != 0 && !moved_out_of_sight_;
  feedback_.valid = !lost_;
  ++feedback_.sequence;
  feedback_from_ = asked;
  watch_following_error(now);
}

// Without contact a drive can only have come to rest: it is at most as far as its last speed would
// have carried it. Further away, its counter no longer tells the position of the machine.
void AxisExchange::check_reference(double position, BusTime now) RT_SAFE {
  if (position_accepted_) {
    moved_out_of_sight_ = false;
  } else if (lost_ && feedback_.sequence > 0 && !follows_velocity_) {
    const double reach =
        speed_before_loss_ * seconds(now - feedback_from_) + config_.following_error_max;
    moved_out_of_sight_ |= std::fabs(position - feedback_.position) > reach;
  }
}

void AxisExchange::watch_following_error(BusTime now) RT_SAFE {
  const double error = follows_velocity_ ? 0.0 : feedback_.following_error;
  if (std::fabs(error) <= config_.following_error_max) {
    following_error_since_.reset();
  } else if (!following_error_since_) {
    following_error_since_ = now;
  }
  feedback_.following_error_exceeded =
      following_error_since_ && now - *following_error_since_ > following_error_time;
}

void AxisExchange::fail() RT_SAFE {
  ++errors_;
  answering_ = false;
  leak_ = std::min(leak_ + failure_weight, leak_max_);
}

void AxisExchange::supervise(BusTime now) RT_SAFE {
  const bool silent = now - feedback_from_ > timeout_;
  if (!lost_ && (silent || leak_ >= leak_max_)) {
    lost_ = true;
    leak_ = leak_max_;
    feedback_.valid = false;
    ++feedback_.losses;
  }
}

}  // namespace stanok::drives
