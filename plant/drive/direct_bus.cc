// One cycle of simulated drives on the virtual clock.
#include "plant/drive/direct_bus.h"

#include <algorithm>
#include <cmath>

#include "base/assert.h"

namespace stanok::plant {
namespace {

drives::BusTime bus_time(Duration duration) {
  return drives::BusTime{static_cast<std::int64_t>(std::llround(duration / second * 1e9))};
}

// What a master on Modbus sees of an answer that is not normal.
drives::ExchangeError error_of(AnswerKind kind) RT_SAFE {
  switch (kind) {
    case AnswerKind::mangled:
      return drives::ExchangeError::mangled;
    case AnswerKind::hang_up:
      return drives::ExchangeError::disconnected;
    default:
      return drives::ExchangeError::timeout;
  }
}

}  // namespace

DirectBus::DirectBus(const drives::BusConfig& config,
                     const std::vector<SimulatedDriveConfig>& drives, Duration cycle)
    : cycle_(bus_time(cycle)), poll_(std::chrono::milliseconds{config.poll_ms}) {
  STANOK_ASSERT(cycle_.count() > 0 && config.poll_ms > 0);
  axes_.reserve(drives.size());
  for (const SimulatedDriveConfig& drive : drives) {
    axes_.push_back(
        {.exchange = {drive.registers, poll_, std::chrono::milliseconds{config.timeout_ms}},
         .drive = SimulatedDrive(drive)});
    names_.push_back(drive.registers.axis);
  }
}

void DirectBus::write(std::span<const drives::DriveTarget> targets) RT_SAFE {
  const bool is_poll = now_ >= next_poll_;
  if (is_poll) {
    next_poll_ = next_poll_ + poll_;
  }
  const std::size_t count = std::min(targets.size(), axes_.size());
  for (std::size_t i = 0; i < count; ++i) {
    if (is_poll) {
      exchange(axes_[i], targets[i]);
    }
    axes_[i].drive.advance(static_cast<double>(cycle_.count()) * 1e-9);
  }
  now_ += cycle_;
}

void DirectBus::exchange(Axis& axis, const drives::DriveTarget& target) RT_SAFE {
  const AnswerKind kind = axis.drive.answer_kind();
  std::optional<drives::ExchangeError> error;
  if (kind != AnswerKind::normal) {
    if (axis.exchange.has_answered())
      static_cast<void>(axis.exchange.command(target, drives::TargetAge::fresh));
    error = error_of(kind);
    axis.exchange.fail(*error);
  } else {
    if (!axis.exchange.has_answered())
      error = axis.exchange.take(axis.drive.status(), now_, now_);  // a first look
    if (!error) {
      axis.drive.command(axis.exchange.command(target, drives::TargetAge::fresh));
      error = axis.exchange.take(axis.drive.status(), now_, now_);
    }
  }
  axis.exchange.supervise(now_);
  ++exchanges_;
  if (error) {
    ++errors_[*error];
  }
}

void DirectBus::read(std::span<drives::DriveFeedback> feedback) RT_SAFE {
  const std::size_t count = std::min(feedback.size(), axes_.size());
  for (std::size_t i = 0; i < count; ++i) {
    Axis& axis = axes_[i];
    feedback[i] = axis.exchange.feedback();
    axis.age_cycles = feedback[i].sequence != axis.sequence_seen ? 0 : axis.age_cycles + 1;
    axis.sequence_seen = feedback[i].sequence;
    feedback[i].age_cycles = axis.age_cycles;
  }
}

drives::BusStatus DirectBus::status() const {
  drives::BusStatus status{.endpoint = "simulated",
                           .connected = true,
                           .connections = 1,
                           .exchanges = exchanges_,
                           .errors = errors_};
  for (std::size_t i = 0; i < axes_.size(); ++i) {
    const drives::DriveFeedback& feedback = axes_[i].exchange.feedback();
    status.axes.push_back({.axis = names_[i],
                           .in_contact = feedback.valid,
                           .answers = feedback.sequence,
                           .errors = axes_[i].exchange.contact().error_count(),
                           .errors_by_kind = axes_[i].exchange.contact().errors(),
                           .feedback = feedback});
  }
  return status;
}

}  // namespace stanok::plant
