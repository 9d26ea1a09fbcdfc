// What one drive is told in an exchange and what of its answer is believed. No sockets, no clock.
//
// The bus asks for the next command, sends it, and reports the answer or the error. From these the
// exchange supervises contact (contact_watch.h). After a loss the drive is told to stop, and it
// stays off until the cycle has taken back `enabled` once: nothing resumes by itself. The same
// holds for the drive of an axis that has left "operation enabled" by itself.
//
// The drive of an axis follows targets of the cycle only while it is on. Until then its target is
// the position it reports itself, so it is never enabled towards a place where the axis is not; and
// it is not enabled while the cycle wants the axis further away than `following_error_max`. A drive
// that has never answered is only looked at: `take` without a `command` before it.
//
// Whether an axis follows is judged twice: by the following error that the drive reports, and by
// the position of an answer against the targets of this exchange and the one before, between which
// a drive may be that takes one exchange to reach a target.
//
// Owned by the bus, on its thread. Time is given by the caller, as the time since the start of the
// bus.
#pragma once

#include <optional>

#include "base/rt_safe.h"
#include "drives/bus.h"
#include "drives/bus_config.h"
#include "drives/cia402.h"
#include "drives/modbus/contact_watch.h"
#include "drives/modbus/drive_registers.h"
#include "drives/modbus/exchange_plan.h"
#include "drives/modbus/fault_reset.h"
#include "drives/modbus/following_watch.h"
#include "drives/modbus/position_reference.h"
#include "drives/modbus/target_watch.h"

namespace stanok::drives {

class AxisExchange {
 public:
  AxisExchange(const AxisDriveConfig& config, BusTime poll, BusTime timeout);

  // Whether it is known where the drive stands: only then may it be written.
  [[nodiscard]] bool has_answered() const RT_SAFE { return feedback_.sequence > 0; }

  // The block to send now.
  [[nodiscard]] CommandBlock command(const DriveTarget& target, TargetAge age) RT_SAFE;

  // In which order the registers of that block are written.
  [[nodiscard]] WriteOrder write_order() const RT_SAFE;

  // Takes the answer to the last command, or says why it is discarded; a discarded answer counts as
  // failed. The values are from some instant between `asked` and `now`.
  [[nodiscard]] std::optional<ExchangeError> take(const StatusBlock& answer, BusTime asked,
                                                  BusTime now) RT_SAFE;

  // The last command had no usable answer.
  void fail(ExchangeError error) RT_SAFE;

  // Contact is lost at once, whatever the time-out says.
  void lose_contact() RT_SAFE;

  // Once per poll, whether or not there was an exchange.
  void supervise(BusTime now) RT_SAFE;

  // `age_cycles` stays 0 here: age is counted where it is read.
  [[nodiscard]] const DriveFeedback& feedback() const RT_SAFE { return feedback_; }
  [[nodiscard]] const ContactWatch& contact() const RT_SAFE { return contact_; }

 private:
  // Whose target the drive was sent last: its own position, the last one of the cycle while it is
  // being stopped, or the cycle's.
  enum class TargetSource : std::uint8_t { actual, held, cycle };
  struct Demand {
    std::int32_t position;
    std::int32_t velocity;
  };
  // What the drive was sent last.
  struct Sent {
    CommandBlock block;
    TargetSource source = TargetSource::actual;
    PowerRequest request = PowerRequest::off;
    double target_position = 0.0;
    // That the drive may be following: sent since the last answer, and the one that it answered.
    Band targets{};
    bool told_reverse = false;   // by a word of its own
    bool awaits_answer = false;  // since the last answer
  };

  [[nodiscard]] std::optional<Demand> demand_of(const DriveTarget& target) const RT_SAFE;
  // `demand`: none when the target cannot be sent.
  [[nodiscard]] PowerRequest request_for(const DriveTarget& target,
                                         const std::optional<Demand>& demand) const RT_SAFE;
  [[nodiscard]] bool may_take_over(const DriveTarget& target) const RT_SAFE;
  [[nodiscard]] TargetSource source_under(PowerRequest request) const RT_SAFE;
  void set_targets(const std::optional<Demand>& demand, const DriveTarget& target) RT_SAFE;
  [[nodiscard]] bool moves_axis() const RT_SAFE { return config_.spindle == 0; }
  // The position of the last answer, as the drive counts: without the offset.
  [[nodiscard]] double counted_position() const RT_SAFE;
  [[nodiscard]] bool is_plausible(const StatusBlock& answer, BusTime now) const RT_SAFE;
  [[nodiscard]] Band reach_out_of_sight() const RT_SAFE;
  void check_reference(double counted) RT_SAFE;
  [[nodiscard]] bool follows_targets() const RT_SAFE;
  void note_target(BusTime asked) RT_SAFE;
  [[nodiscard]] double deviation() const RT_SAFE;
  void watch_following_error(double reported, BusTime now) RT_SAFE;
  [[nodiscard]] std::uint16_t word_for(PowerRequest request, double velocity) const RT_SAFE;
  [[nodiscard]] std::optional<DriveState> state_in(const StatusBlock& answer) const RT_SAFE;
  [[nodiscard]] double velocity_in(const StatusBlock& answer) const RT_SAFE;
  [[nodiscard]] bool has_direction_in_word() const RT_SAFE;
  [[nodiscard]] bool is_referenced(const StatusBlock& answer) const RT_SAFE;
  void take_measurements(const StatusBlock& answer) RT_SAFE;
  void accept(const StatusBlock& answer, DriveState state, BusTime asked, BusTime now) RT_SAFE;

  AxisDriveConfig config_;
  ContactWatch contact_;
  PositionReference reference_;
  FollowingWatch following_;
  FaultReset fault_reset_;
  Sent sent_;
  DriveFeedback feedback_;
  double velocity_before_loss_ = 0.0;  // the faster of target and actual velocity
  bool follows_velocity_ = false;
  bool enable_blocked_ = false;
  bool has_had_voltage_ = false;
};

}  // namespace stanok::drives
